// SPDX-License-Identifier: Apache-2.0
// Runs of robots that consist of several files, with meshes: what is in their folders, and that it
// opens where it lies.
#include <gtest/gtest.h>

#include <map>

#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/support/long_tests.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

const std::vector<std::string> kParts{"parts/defaults.xml", "parts/front_left.xml",
                                      "parts/shank.xml", "parts/drives.xml"};
const std::vector<std::string> kAssets{"assets/ear.stl", "assets/nose.obj",
                                       "assets/pictures/fur.png"};

/// Opens a file from another folder than its own, as people do.
ModelPointer opened(const fs::path& file) {
  static const bool loaded = [] {
    mj_loadPluginLibrary((test::binary_dir() + "/bin/mujoco_plugin/liblegwright.so").c_str());
    return true;
  }();
  EXPECT_TRUE(loaded);
  char error[1000] = "";
  ModelPointer model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(model) << file << ": " << error;
  return model;
}

class RobotFilesRun : public testing::Test, protected test::CallsInFolder {
 protected:
  void SetUp() override {
    test::write_split_puppy(home_);
    const std::string task = read_file(test::kExamples / "puppy" / "sideways.toml");
    write_file(home_ / "sideways.toml", test::with(task, "\"robot.xml\"", "\"dog.xml\""));
  }
  void optimize(const std::string& task, const std::string& run) const {
    const Outcome outcome = call({"optimize", task, "--plan-only", "--max-iterations", "2",
                                  "--no-reasons", "--no-pictures", "-o", run});
    ASSERT_LE(outcome.code, 1) << outcome.err;
  }
  /// Everything below a folder but what tells the time.
  std::map<std::string, std::string> contents(const fs::path& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / folder))
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), folder_.path() / folder).string()] =
            read_file(entry.path());
    return files;
  }
  void expect_robot(const fs::path& design) const {
    for (const std::string& part : kParts) EXPECT_TRUE(fs::is_regular_file(design / part)) << part;
    for (const std::string& asset : kAssets)
      EXPECT_EQ(read_file(design / asset), read_file(folder_.path() / "run/inputs" / asset));
    const ModelPointer robot = opened(design / "robot.xml");
    ASSERT_TRUE(robot);
    EXPECT_EQ(robot->nmesh, 2);
  }
  fs::path home_ = folder_.path() / "home", run_ = folder_.path() / "run";
};

TEST_F(RobotFilesRun, InitWritesBesideTheMainFileByABareName) {
  const Outcome bare = test::call_in(home_, {"init", "dog.xml", "-o", "new.xml"});
  EXPECT_EQ(bare.code, 0) << bare.err;
  EXPECT_TRUE(fs::exists(home_ / "new.xml"));
  EXPECT_FALSE(fs::exists(home_ / "robot.xml"));
}

TEST_F(RobotFilesRun, EveryFolderHoldsTheWholeRobotAndOpens) {
  optimize("home/sideways.toml", "run");
  // The user's files are as they were, and the initial design is them, file by file.
  const fs::path untouched = folder_.path() / "again";
  test::write_split_puppy(untouched);
  for (std::string part : kParts) {
    EXPECT_EQ(read_file(home_ / part), read_file(untouched / part)) << part;
    EXPECT_EQ(read_file(run_ / "iterations/0000" / part), read_file(home_ / part)) << part;
  }
  EXPECT_EQ(read_file(home_ / "dog.xml"), read_file(untouched / "dog.xml"));
  EXPECT_EQ(read_file(run_ / "iterations/0000/robot.xml"), read_file(home_ / "dog.xml"));
  EXPECT_EQ(read_file(run_ / "inputs/robot.xml"), read_file(home_ / "dog.xml"));
  EXPECT_NE(read_file(run_ / "result/parts/shank.xml"), read_file(home_ / "parts/shank.xml"));

  // From here on the run stands for itself.
  fs::remove_all(home_);
  for (const char* folder : {"inputs", "iterations/0000", "iterations/0002", "result"})
    expect_robot(run_ / folder);
  for (const char* folder : {"iterations/0000", "iterations/0002", "result"}) {
    const ModelPointer scene = opened(run_ / folder / "scene.xml");
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->nmesh, 2);
    EXPECT_EQ(scene->nkey, 2);
  }
  // One copy on the disk: inputs, three iterations and the result share it.
  EXPECT_EQ(fs::hard_link_count(run_ / "inputs/assets/ear.stl"), 5u);
  EXPECT_EQ(fs::hard_link_count(run_ / "result/parts/shank.xml"), 1u);
  const Json run = read_json(run_ / "run.json");
  for (const std::string& file : {kParts[2], kAssets[0], std::string("robot.xml")})
    EXPECT_EQ(run["sha256"][file], sha256_hex(read_file(run_ / "inputs" / file))) << file;
  const Outcome validate = call({"validate", "run", "--quick"});
  EXPECT_LE(validate.code, 1) << validate.err;
  EXPECT_TRUE(fs::exists(run_ / "result/verdict.json")) << validate.err;

  // The inputs are a task like any other, with the same result.
  optimize("run/inputs/task.toml", "rerun");
  EXPECT_EQ(contents("rerun/iterations"), contents("run/iterations"));
  EXPECT_EQ(contents("rerun/inputs"), contents("run/inputs"));

  // In place of itself it would take its own meshes away.
  const auto before = contents("run");
  const Outcome itself = call({"optimize", "run/inputs/task.toml", "-o", "run", "--force"});
  EXPECT_EQ(itself.code, 3);
  EXPECT_TRUE(contains(itself.err, "the robot's own files lie in it")) << itself.err;
  EXPECT_EQ(contents("run"), before);
}

TEST_F(RobotFilesRun, PhysicsStepsFindTheMeshes) {
  LEGWRIGHT_LONG_TEST();
  const Outcome outcome =
      call({"optimize", "home/sideways.toml", "--plan-only", "--max-iterations", "1",
            "--no-reasons", "--no-pictures", "--physics-steps", "1", "-o", "run"});
  ASSERT_LE(outcome.code, 1) << outcome.err;
  const Json steps = read_json(run_ / "run.json")["physics_steps"];
  EXPECT_GT(steps["rollouts"].get<int>(), 0);
  EXPECT_FALSE(steps["before"]["merit"].is_null()) << steps.dump();  // the start could be played
  expect_robot(run_ / "result");
}

TEST_F(RobotFilesRun, JointRunsShareTheMeshes) {
  std::string task = read_file(home_ / "sideways.toml");
  const std::size_t gait = task.find("[gait]");
  std::string rest = task.substr(gait);
  std::string both = task.substr(0, gait);
  for (const char* name : {"left", "right"}) {
    std::string own = rest;
    for (const char* table : {"gait", "travel", "style", "limits"}) {
      const std::string head = std::string("[").append(table).append("]");
      if (own.find(head) != std::string::npos)
        own = test::with(own, head, std::string("[task.").append(table).append("]"));
    }
    if (name == std::string("right")) own = test::with(own, "[0.0, 0.1]", "[0.0, -0.1]");
    both.append("[[task]]\nname = \"").append(name).append("\"\n").append(own).append("\n");
  }
  write_file(home_ / "both.toml", both);
  const Outcome outcome = call({"optimize", "home/both.toml", "--plan-only", "--max-iterations",
                                "1", "--no-reasons", "--no-pictures", "--one-start", "-o", "run"});
  ASSERT_LE(outcome.code, 1) << outcome.err;
  expect_robot(run_ / "result");
  for (const char* folder :
       {"tasks/left/inputs", "tasks/left/iterations/0000", "tasks/right/result"})
    expect_robot(run_ / folder);
  const std::uintmax_t links = fs::hard_link_count(run_ / "inputs/assets/ear.stl");
  std::uintmax_t copies = 0;
  for (const auto& entry : fs::recursive_directory_iterator(run_))
    copies += entry.path().filename() == "ear.stl";
  EXPECT_EQ(links, copies);
  EXPECT_GT(copies, 6u);
}

TEST_F(RobotFilesRun, InitAndDiffReadThem) {
  const Outcome init = call({"init", "home/dog.xml", "--json"});
  EXPECT_EQ(init.code, 0) << init.err;
  EXPECT_EQ(Json::parse(init.out)["declared"].size(), 20u);
  std::string dog = read_file(home_ / "dog.xml");
  const std::size_t begin = dog.find("  <custom>"), end = dog.find("</custom>\n");
  write_file(home_ / "dog.xml", dog.erase(begin, end + 10 - begin));
  const auto before = contents("home/parts");
  const Outcome elsewhere = call({"init", "home/dog.xml", "-o", "other/dog.xml"});
  EXPECT_EQ(elsewhere.code, 0) << elsewhere.err;
  for (const std::string& part : kParts)
    EXPECT_EQ(read_file(folder_.path() / "other" / part), read_file(home_ / part)) << part;
  for (const std::string& asset : kAssets)
    EXPECT_EQ(read_file(folder_.path() / "other" / asset), read_file(home_ / asset)) << asset;
  EXPECT_TRUE(opened(folder_.path() / "other/dog.xml"));
  const Outcome beside = call({"init", "home/dog.xml", "-o", "home/dog2.xml"});
  EXPECT_EQ(beside.code, 0) << beside.err;
  const Outcome write = call({"init", "home/dog.xml", "--write"});
  EXPECT_EQ(write.code, 0) << write.err;
  EXPECT_EQ(read_file(home_ / "dog.xml"), read_file(home_ / "dog2.xml"));
  EXPECT_EQ(read_file(home_ / "dog.xml"), read_file(folder_.path() / "other/dog.xml"));
  EXPECT_TRUE(contains(read_file(home_ / "dog.xml"), "legwright/front_shank_length"));
  EXPECT_EQ(contents("home/parts"), before);

  EXPECT_EQ(call({"diff", "home/dog.xml", "home/dog2.xml"}).code, 0);
  const std::string whole = (test::kExamples / "puppy" / "robot.xml").string();
  const Outcome diff = call({"diff", whole, "home/dog.xml"});
  EXPECT_EQ(diff.code, 1) << diff.err;  // two meshes more, and the same numbers
  EXPECT_FALSE(contains(diff.out, "L_thigh")) << diff.out;
  EXPECT_TRUE(contains(diff.out, "parameter 'hind_thigh_length'")) << diff.out;  // other bounds
  const std::string shank = read_file(home_ / "parts/shank.xml");
  write_file(home_ / "parts/shank.xml",
             test::with(shank, "pos=\"0 0 -0.06\"", "pos=\"0 0 -0.07\""));
  const Outcome moved = call({"diff", whole, "home/dog.xml"});
  EXPECT_TRUE(contains(moved.out, "FL_shank")) << moved.out;
  write_file(home_ / "parts/shank.xml", test::with(shank, "<geom", "<wheel"));
  const Outcome broken = call({"diff", whole, "home/dog.xml"});
  EXPECT_EQ(broken.code, 2);
  EXPECT_TRUE(contains(broken.err, "home/parts/shank.xml:4: MuJoCo")) << broken.err;
}

TEST_F(RobotFilesRun, NothingIsWrittenForARefusedFile) {
  fs::create_symlink("/etc/hostname", home_ / "assets/tail.stl");
  write_file(home_ / "dog.xml", test::with(read_file(home_ / "dog.xml"), "ear.stl", "tail.stl"));
  const Outcome outcome = call({"optimize", "home/sideways.toml", "-o", "run", "--confined"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "dog.xml:")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err,
                       "is reached by a symbolic link and lies at /etc/hostname, "
                       "outside of the folder of the robot's main file, and "
                       "--confined was given: copy it"))
      << outcome.err;
  EXPECT_FALSE(fs::exists(run_));
}

}  // namespace
}  // namespace legwright
