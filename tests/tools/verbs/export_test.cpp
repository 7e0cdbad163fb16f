// SPDX-License-Identifier: Apache-2.0
// legwright export: the robot of a run in a folder of its own.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>
#include <set>
#include <utility>

#include "tests/tools/verbs/program.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::kExamples;
using test::Outcome;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A run of one iteration of a robot that stands in a folder of its own, with a licence.
class Export : public testing::Test, protected test::CallsInFolder {
 protected:
  void SetUp() override { optimize("puppy"); }

  void optimize(const std::string& model) {
    fs::remove_all(root() / "mine");
    fs::create_directories(root() / "mine");
    const fs::path from = kExamples / "puppy";
    write_file(
        root() / "mine" / "robot.xml",
        replaced(read_file(from / "robot.xml"), "model=\"puppy\"", "model=\"" + model + "\""));
    write_file(root() / "mine" / "task.toml", read_file(from / "sideways.toml"));
    write_file(root() / "mine" / "LICENSE", "Do what is right.\n");
    const Outcome done =
        call({"optimize", "mine/task.toml", "-o", "run", "--force", "--plan-only",
              "--max-iterations", "1", "--no-pictures", "--no-certificate", "--no-reasons"});
    ASSERT_TRUE(done.code == 0 || done.code == 1) << done.err;
  }

  /// A mesh on the robot's eyes: `part`, which it includes, names it, `shape` holds it.
  void give_mesh(const std::string& part, const std::string& shape) const {
    const fs::path mine = root() / "mine";
    fs::create_directories((mine / shape).parent_path());
    write_file(mine / shape,
               "v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\nv 0 0 0.01\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    write_file(mine / part,
               "<mujoco><asset><mesh name=\"dot\" file=\"" + shape + "\"/></asset></mujoco>\n");
    const std::string eyes = "<body name=\"eyes\" pos=\"0.095 0 0\">";
    write_file(mine / "robot.xml", replaced(replaced(read_file(mine / "robot.xml"), "<asset>",
                                                     "<include file=\"" + part + "\"/><asset>"),
                                            eyes, eyes + "<geom type=\"mesh\" mesh=\"dot\"/>"));
  }

  fs::path root() const { return folder_.path(); }
};

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) out.insert(fs::relative(entry.path(), folder).string());
  return out;
}

TEST_F(Export, MakesAFolderThatStockMujocoOpens) {
  const Outcome done = call({"export", "run", "-o", "puppy", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json told = Json::parse(done.out);
  EXPECT_EQ(told["schema"], "legwright/export");
  EXPECT_EQ(told["engine_warnings"], 0);
  const fs::path folder = root() / "puppy";
  const std::set<std::string> files = files_in(folder);
  for (const char* name : {"puppy.xml", "scene.xml", "README.md", "LICENSE", "walk.xml",
                           "plugin_walk.xml", "gait.csv", "gains.json", "play.py"})
    EXPECT_EQ(files.count(name), 1u) << name;
  EXPECT_EQ(std::set<std::string>(told["files"].begin(), told["files"].end()), files);
  EXPECT_EQ(read_file(folder / "puppy.xml"), read_file(root() / "run" / "result" / "robot.xml"));
  EXPECT_EQ(read_file(folder / "LICENSE"), "Do what is right.\n");

  char error[500] = "";
  const std::unique_ptr<mjModel, void (*)(mjModel*)> scene(
      mj_loadXML((folder / "scene.xml").c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(scene) << error;
  EXPECT_EQ(scene->nplugin, 0);
  EXPECT_EQ(scene->nu, 12);
  EXPECT_GE(mj_name2id(scene.get(), mjOBJ_GEOM, "floor"), 0);
  EXPECT_GE(mj_name2id(scene.get(), mjOBJ_KEY, "home"), 0);

  // The gait with the plugin says how that is loaded; the one without has nothing to load.
  const std::string played = read_file(folder / "plugin_walk.xml");
  EXPECT_EQ(played, read_file(root() / "run" / "result" / "scene.xml"));
  EXPECT_TRUE(test::contains(played, "<!-- An engine plugin plays the gait"));
  EXPECT_FALSE(test::contains(read_file(folder / "walk.xml"), "engine plugin"));
  const std::unique_ptr<mjModel, void (*)(mjModel*)> walk(
      mj_loadXML((folder / "walk.xml").c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(walk) << error;
  EXPECT_EQ(walk->nplugin, 0);
  EXPECT_EQ(walk->nu, 12);
  EXPECT_GE(mj_name2id(walk.get(), mjOBJ_KEY, "gait"), 0);
  const Outcome back = call({"init", "puppy/walk.xml", "-o", "again.xml", "--task", "again.toml"});
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_EQ(call({"check", "again.toml"}).code, 0);
  const Json gains = read_json(folder / "gains.json");
  ASSERT_EQ(gains["servos"].size(), 12u);
  const std::string columns = read_file(folder / "gait.csv");
  for (const Json& servo : gains["servos"]) {
    EXPECT_GE(mj_name2id(walk.get(), mjOBJ_ACTUATOR, servo["actuator"].get<std::string>().c_str()),
              0);
    EXPECT_TRUE(contains(columns, servo["target"].get<std::string>() + ","));
    EXPECT_GT(servo["kp"].get<double>(), 0.0);
  }

  const std::string readme = read_file(folder / "README.md");
  for (const std::string& part :
       {std::string("# puppy\n"), std::string("python play.py --view"),
        sha256_hex(read_file(root() / "mine" / "robot.xml")),
        sha256_hex(read_file(root() / "mine" / "task.toml")), std::string("mine/robot.xml"),
        std::string("--max-iterations 1"), std::string("| front\\_thigh\\_length | 0.06 |"),
        std::string("was not validated"), std::string("no warning of the engine"),
        std::string("Carried over from beside the robot's file: LICENSE.")})
    EXPECT_TRUE(contains(readme, part)) << part << " in:\n" << readme;
}

/// A keyframe without `ctrl`, placed 7 mm too low by eye: the export holds its pose on the ground.
TEST_F(Export, ARobotWithoutControlsAtHomeStands) {
  const fs::path mine = root() / "mine";
  fs::create_directories(mine);
  const std::string robot = read_file(kExamples.parent_path() / "tests/robots/servo_dog/robot.xml");
  write_file(mine / "dog.xml", replaced(robot, "0 0 0.141102 1 0 0 0", "0 0 0.134102 1 0 0 0"));
  ASSERT_EQ(call({"init", "mine/dog.xml", "--write", "--task", "mine/dog.toml"}).code, 0);
  const Outcome run = call({"optimize", "mine/dog.toml", "-o", "dog", "--plan-only",
                            "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(run.code == 0 || run.code == 1) << run.err;
  const Outcome done = call({"export", "dog", "-o", "there", "--no-picture"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(test::contains(done.out, "is the export's")) << done.out;
  EXPECT_FALSE(test::contains(done.out, "deep in the ground")) << done.out;
  EXPECT_FALSE(test::contains(done.out, "another place")) << done.out;
}

/// A search that leaves the body as it was keeps its file, to the byte: the export lifts it.
TEST_F(Export, AnUnchangedBodyStandsOnTheGroundToo) {
  const fs::path mine = root() / "mine";
  fs::create_directories(mine);
  const std::string robot = read_file(kExamples.parent_path() / "tests/robots/servo_dog/robot.xml");
  write_file(mine / "dog.xml", replaced(robot, "0 0 0.141102 1 0 0 0", "0 0 0.134102 1 0 0 0"));
  ASSERT_EQ(call({"init", "mine/dog.xml", "-o", "mine/new.xml", "--task", "mine/dog.toml"}).code,
            0);
  std::string fixed = read_file(mine / "dog.toml");
  fixed = replaced(fixed, "new.xml", "dog.xml");  // no design parameters
  write_file(mine / "dog.toml", fixed);
  const Outcome run = call({"optimize", "mine/dog.toml", "-o", "same", "--plan-only",
                            "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(run.code == 0 || run.code == 1) << run.err;
  const Outcome done = call({"export", "same", "-o", "lifted", "--no-picture"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.out, "the trunk is up to 0.007 m higher")) << done.out;
  EXPECT_FALSE(contains(done.out, "deep in the ground")) << done.out;
  EXPECT_TRUE(contains(read_file(root() / "lifted" / "servo_dog.xml"), "qpos=\"0 0 0.1411"));
}

/// Stands on bent legs as it is drawn; a keyframe there is none.
std::string keyless_dog() {
  std::string legs, servos;
  for (const auto& [name, place] :
       {std::pair{"fl", ".15 .08 0"}, std::pair{"fr", ".15 -.08 0"}, std::pair{"hl", "-.15 .08 0"},
        std::pair{"hr", "-.15 -.08 0"}}) {
    legs += fmt::format(
        R"(<body name="{0}_thigh" pos="{1}" euler="0 .6 0"><joint name="{0}_hip" axis="0 1 0"/>
        <geom type="capsule" size=".015" fromto="0 0 0 0 0 -.2" mass=".3"/>
        <body name="{0}_shank" pos="0 0 -.2" euler="0 -1.2 0"><joint name="{0}_knee" axis="0 1 0"/>
        <geom type="capsule" size=".012" fromto="0 0 0 0 0 -.2" mass=".1"/>
        <geom name="{0}_foot" size=".02" pos="0 0 -.2" mass=".02"/></body></body>)",
        name, place);
    for (const char* joint : {"hip", "knee"})
      servos += fmt::format(R"(<position joint="{}_{}" kp="200" forcerange="-9 9"/>)", name, joint);
  }
  return R"(<mujoco model="keyless"><compiler angle="radian"/><worldbody>
         <body name="trunk" pos="0 0 .3501"><freejoint/>
         <geom type="box" size=".15 .05 .03" mass="3"/>)" +
         legs + "</body></worldbody><actuator>" + servos + "</actuator></mujoco>";
}

/// Nothing says where the trunk is of a body with other legs: it stood in the floor.
TEST_F(Export, ARobotWithoutKeyframeStandsOnItsNewLegs) {
  fs::create_directories(root() / "mine");
  write_file(root() / "mine" / "dog.xml", keyless_dog());
  ASSERT_EQ(call({"init", "mine/dog.xml", "--write", "--task", "mine/dog.toml"}).code, 0);
  ASSERT_FALSE(contains(read_file(root() / "mine" / "dog.xml"), "<key")) << "it stands";
  const Outcome run = call({"optimize", "mine/dog.toml", "-o", "keyless", "--plan-only",
                            "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(run.code == 0 || run.code == 1) << run.err;
  const Outcome done = call({"export", "keyless", "-o", "stands", "--no-picture"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.out, "keyframe legwright is the export's")) << done.out;
  EXPECT_FALSE(contains(done.out, "deep in the ground")) << done.out;
}

TEST_F(Export, RefusesToOverwriteAndLeavesNothingBehind) {
  ASSERT_EQ(call({"export", "run", "-o", "there", "--no-picture"}).code, 0);
  const auto before = fs::last_write_time(root() / "there" / "README.md");
  const Outcome again = call({"export", "run", "-o", "there"});
  EXPECT_EQ(again.code, 3);
  EXPECT_TRUE(contains(again.err, "exists already; name a new folder")) << again.err;
  EXPECT_EQ(fs::last_write_time(root() / "there" / "README.md"), before);

  EXPECT_EQ(call({"export", "nowhere", "-o", "other"}).code, 3);
  // A result that is not the design which it declares.
  const fs::path result = root() / "run" / "result" / "robot.xml";
  const std::string good = read_file(result);
  write_file(result, replaced(good, "mass=\"1\"", "mass=\"1.5\""));
  const Outcome changed = call({"export", "run", "-o", "other"});
  EXPECT_EQ(changed.code, 2);
  EXPECT_TRUE(contains(changed.err, "mass of link trunk")) << changed.err;
  write_file(result, good);
  // A robot at the start that the run did not start from.
  const fs::path input = root() / "run" / "inputs" / "robot.xml";
  write_file(input, read_file(input) + "\n");
  EXPECT_TRUE(contains(call({"export", "run", "-o", "other"}).err, "SHA-256"));
  fs::remove(result);
  EXPECT_EQ(call({"export", "run", "-o", "other"}).code, 3);
  EXPECT_FALSE(fs::exists(root() / "other"));
  for (const auto& entry : fs::directory_iterator(root()))
    EXPECT_FALSE(contains(entry.path().filename().string(), ".tmp")) << entry.path();
}

TEST_F(Export, NamesOfModelsAreNoPathsAndNoMarkup) {
  optimize("../../&lt;b&gt;x|y` [a](b)");
  const Outcome done = call({"export", "run", "--no-picture"});
  ASSERT_EQ(done.code, 0) << done.err;
  const fs::path folder = root() / "exports" / "run";
  EXPECT_TRUE(fs::exists(folder / "_______b_x_y___a__b_.xml"));
  const std::string readme = read_file(folder / "README.md");
  EXPECT_EQ(readme.substr(0, readme.find('\n')), "# ../../&lt;b&gt;x\\|y\\` \\[a\\](b)");
}

/// Parts and meshes come along, as files of their own: not links into the run.
TEST_F(Export, ARobotOfSeveralFilesKeepsThem) {
  give_mesh("skin.xml", "assets/dot.obj");
  const Outcome made =
      call({"optimize", "mine/task.toml", "-o", "run", "--force", "--plan-only", "--max-iterations",
            "1", "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(made.code == 0 || made.code == 1) << made.err;
  const Outcome done = call({"export", "run", "-o", "there", "--no-picture"});
  ASSERT_EQ(done.code, 0) << done.err;
  const fs::path folder = root() / "there";
  EXPECT_EQ(read_file(folder / "skin.xml"), read_file(root() / "mine" / "skin.xml"));
  EXPECT_EQ(read_file(folder / "assets" / "dot.obj"),
            read_file(root() / "mine" / "assets" / "dot.obj"));
  EXPECT_EQ(fs::hard_link_count(folder / "assets" / "dot.obj"), 1u);
  EXPECT_TRUE(contains(read_file(folder / "puppy.xml"), "<include file=\"skin.xml\"/>"));
  EXPECT_TRUE(contains(read_file(folder / "README.md"), "assets/dot.obj"));
  char error[500] = "";
  const std::unique_ptr<mjModel, void (*)(mjModel*)> scene(
      mj_loadXML((folder / "scene.xml").c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(scene) << error;
  EXPECT_EQ(scene->nmesh, 1);
  const std::unique_ptr<mjModel, void (*)(mjModel*)> walk(
      mj_loadXML((folder / "walk.xml").c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(walk) << error;
  EXPECT_EQ(walk->nmesh, 1);
}

/// A part that is called like the model keeps its name; parts that are no longer what the run read
/// are refused.
TEST_F(Export, PartsKeepTheirNamesAndTheirSums) {
  give_mesh("puppy.xml", "dot.obj");
  const Outcome made =
      call({"optimize", "mine/task.toml", "-o", "run", "--force", "--plan-only", "--max-iterations",
            "0", "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(made.code == 0 || made.code == 1) << made.err;
  const Outcome done = call({"export", "run", "-o", "there", "--no-picture", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(Json::parse(done.out)["robot"], "puppy_robot.xml");
  EXPECT_EQ(read_file(root() / "there" / "puppy.xml"), read_file(root() / "mine" / "puppy.xml"));
  EXPECT_TRUE(contains(read_file(root() / "there" / "scene.xml"), "puppy_robot.xml"));

  for (const fs::path& part :
       {fs::path("inputs/puppy.xml"), fs::path("inputs/dot.obj"), fs::path("result/dot.obj")}) {
    const fs::path file = root() / "run" / part;
    const std::string good = read_file(file);
    fs::remove(file);  // the run's folders share assets as hard links
    write_file(file, good + (part.extension() == ".obj" ? "# more\n" : "<!-- more -->\n"));
    const Outcome refused = call({"export", "run", "-o", "other", "--no-picture"});
    EXPECT_EQ(refused.code, 2) << part;
    EXPECT_TRUE(
        contains(refused.err, part.filename().string() + ": is not what the run started from"))
        << refused.err;
    write_file(file, good);
  }
  EXPECT_EQ(call({"export", "run", "-o", "other", "--no-picture"}).code, 0);  // control
}

/// Balls about both left hips, 2 mm apart, which meet once the body gets shorter.
TEST_F(Export, LegsThatCameTogetherAreToldOf) {
  const Outcome clear = call({"export", "run", "-o", "clear", "--no-picture"});
  EXPECT_FALSE(contains(clear.err + read_file(root() / "clear" / "README.md"), "touches itself"));

  std::string xml = read_file(root() / "mine" / "robot.xml");
  for (const std::string leg : {"FL", "HL"}) {
    const std::string thigh = "<body name=\"" + leg + "_thigh\"";
    const std::size_t end = xml.find('>', xml.find(thigh)) + 1;
    xml.insert(end, "<geom name=\"" + leg +
                        "_hub\" type=\"sphere\" size=\"0.119\" mass=\"1e-3\" contype=\"1\" "
                        "conaffinity=\"1\"/>");
  }
  write_file(root() / "mine" / "robot.xml", xml);
  const Outcome made =
      call({"optimize", "mine/task.toml", "-o", "run", "--force", "--plan-only", "--max-iterations",
            "3", "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(made.code == 0 || made.code == 1) << made.err;
  for (const Json& p : read_json(root() / "run" / "run.json")["parameters"]) {
    if (p["name"] != "body_length") continue;
    EXPECT_LT(p["final"].get<double>(), 0.237);
  }
  const std::string hubs = "geom 'FL_hub' of 'FL_thigh' and geom 'HL_hub' of 'HL_thigh'";
  const Outcome done = call({"export", "run", "-o", "there", "--no-picture"});
  EXPECT_TRUE(contains(done.err, hubs)) << done.err;
  EXPECT_TRUE(contains(read_file(root() / "there" / "README.md"), "**It touches itself**"));
  write_file(root() / "turns.toml", "turn_ratio.low = 5.0\nturn_ratio.high = 6.0\n");
  const Outcome judged =
      call({"validate", "run", "--quick", "--cycles", "4", "--limits", "turns.toml"});
  EXPECT_TRUE(contains(judged.out, "warning: limits that judge nothing of this task: turn_ratio"))
      << judged.out;
  EXPECT_TRUE(contains(judged.out, "warning: in its home pose the designed body touches itself"))
      << judged.out;
  EXPECT_TRUE(contains(judged.out, hubs)) << judged.out;
  const Json verdict = read_json(root() / "run" / "result" / "verdict.json");
  EXPECT_GT(verdict["home_touches"]["pairs"][0]["depth_m"], 1e-3);
  EXPECT_EQ(verdict["not_judged"]["limits"], Json({"turn_ratio"}));
  EXPECT_EQ(verdict["not_judged"]["line"], "limits that judge nothing of this task: turn_ratio");
}

TEST_F(Export, ALinkIsNoLicence) {
  fs::remove(root() / "mine" / "LICENSE");
  fs::create_symlink("/etc/hostname", root() / "mine" / "LICENSE");
  const Outcome again =
      call({"optimize", "mine/task.toml", "-o", "run", "--force", "--plan-only", "--max-iterations",
            "0", "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(again.code == 0 || again.code == 1) << again.err;
  ASSERT_EQ(call({"export", "run", "-o", "there", "--no-picture"}).code, 0);
  EXPECT_FALSE(fs::exists(root() / "there" / "LICENSE"));
  EXPECT_TRUE(contains(read_file(root() / "there" / "README.md"), "No licence stood beside"));
}

TEST_F(Export, WritesUrdfAndARosPackageAndTellsWhatTheyLack) {
  const Outcome done = call({"export", "run", "-o", "dog", "--ros", "--no-picture"});
  ASSERT_EQ(done.code, 0) << done.err;
  const std::string readme = read_file(root() / "dog" / "README.md");
  for (const char* lost : {"armature, the reflected inertia of rotors (joints: 12)",
                           "gains of actuators (12)", "keyframes, the home pose among them (1)"}) {
    EXPECT_TRUE(contains(done.out, std::string("not in the URDF: ") + lost + "\n")) << done.out;
    EXPECT_TRUE(contains(readme, std::string("- ") + lost + "\n")) << readme;
  }
  EXPECT_TRUE(contains(readme, "ros2 launch puppy walk.launch.py"));
  EXPECT_TRUE(contains(readme, "`urdf/puppy.urdf`"));
  const Json gait = read_json(root() / "dog/ros/puppy/config/gait.yaml");
  EXPECT_EQ(gait["points"].size(), 25u);
  char error[500] = "";
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML((root() / "dog/urdf/puppy.urdf").c_str(), nullptr, error, sizeof error),
      mj_deleteModel);
  ASSERT_TRUE(model) << error;
  EXPECT_EQ(model->nv, 12);
  const Outcome plain = call({"export", "run", "-o", "plain", "--no-picture"});
  EXPECT_FALSE(fs::exists(root() / "plain" / "urdf"));
  EXPECT_FALSE(contains(plain.out, "URDF"));
}

TEST_F(Export, AFolderUrdfOfTheRobotIsNotMixedWithTheExports) {
  give_mesh("dots.xml", "urdf/dot.obj");
  const Outcome again =
      call({"optimize", "mine/task.toml", "-o", "run", "--force", "--plan-only", "--max-iterations",
            "1", "--no-pictures", "--no-certificate", "--no-reasons"});
  ASSERT_TRUE(again.code == 0 || again.code == 1) << again.err;
  const Outcome refused = call({"export", "run", "-o", "dog", "--urdf", "--no-picture"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_TRUE(contains(refused.err, "urdf: the robot has files there")) << refused.err;
  EXPECT_FALSE(fs::exists(root() / "dog"));
}

}  // namespace
}  // namespace legwright
