// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/robot_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/model_diff.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::put;
using test::TemporaryFolder;

std::vector<std::string> paths(const std::vector<IncludedFile>& files) {
  std::vector<std::string> out;
  for (const IncludedFile& file : files) out.push_back(file.path.string());
  return out;
}

std::vector<std::string> paths(const std::vector<AssetFile>& files) {
  std::vector<std::string> out;
  for (const AssetFile& file : files) out.push_back(file.path.string());
  return out;
}

/// As stock MuJoCo reads the files from the disk, includes and all.
ModelPointer opened_by_mujoco(const fs::path& file) {
  char error[1000] = "";
  ModelPointer model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(model) << error;
  return model;
}

std::string error_message(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string error_message(const fs::path& file) {
  return error_message([&] { read_robot(file); });
}

class SplitPuppy : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path file_ = test::write_split_puppy(folder_.path());
};

TEST_F(SplitPuppy, IsTheRobotThatMujocoReads) {
  const RobotFiles files = RobotFiles::read(file_);
  EXPECT_EQ(paths(files.includes()),
            (std::vector<std::string>{"parts/defaults.xml", "parts/front_left.xml",
                                      "parts/shank.xml", "parts/drives.xml"}));
  EXPECT_EQ(paths(files.assets()), (std::vector<std::string>{"assets/ear.stl", "assets/nose.obj",
                                                             "assets/pictures/fur.png"}));
  EXPECT_EQ(files.main_text(), test::read_file(file_));
  for (const IncludedFile& included : files.includes())
    EXPECT_EQ(included.text, test::read_file(folder_.path() / included.path));
  const ModelPointer stock = opened_by_mujoco(file_),
                     ours = compile_mjcf(files.text(), file_, MeshDetail::triangles);
  EXPECT_TRUE(model_differences(*stock, *ours, 0.0).empty());
  EXPECT_EQ(ours->nmesh, 2);
  EXPECT_EQ(ours->ntex, 1);
}

TEST_F(SplitPuppy, IsTheSameRobotAsInOneFile) {
  const RobotModel whole = read_robot(test::puppy_file()), split = read_robot(file_);
  EXPECT_EQ(split.space.initial(), whole.space.initial());
  EXPECT_EQ(split.morphology.total_mass(), whole.morphology.total_mass());
  EXPECT_EQ(split.morphology.joint_count(), whole.morphology.joint_count());
  EXPECT_TRUE(whole.files.includes().empty());
  EXPECT_TRUE(whole.files.assets().empty());
  EXPECT_EQ(whole.files.text(), whole.xml);
}

TEST_F(SplitPuppy, InitialDesignGivesEveryFileBack) {
  const RobotModel robot = read_robot(file_);
  const RobotFiles same = robot.files.with_text(rewrite_robot(robot, robot.space.initial()));
  EXPECT_EQ(same.main_text(), robot.files.main_text());
  for (std::size_t k = 0; k < same.includes().size(); ++k)
    EXPECT_EQ(same.includes()[k].text, robot.files.includes()[k].text);
}

/// Each file of a design, written to another folder, is the old one but for numbers; together they
/// are the robot that was meant.
TEST_F(SplitPuppy, DesignsChangeEachFileForItself) {
  const RobotModel robot = read_robot(file_);
  std::mt19937 random(5);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);
    const RobotFiles files = robot.files.with_text(text);
    const TemporaryFolder folder;
    put(folder.path() / "dog.xml", files.main_text());
    for (const IncludedFile& included : files.includes())
      put(folder.path() / included.path, included.text);
    for (const AssetFile& asset : files.assets())
      put(folder.path() / asset.path, test::read_file(asset.source));
    const RobotModel read =
        parse_robot(RobotFiles::read(folder.path() / "dog.xml"), &robot.structure);
    EXPECT_EQ(read.files.text(), text);
    EXPECT_LT((read.space.initial() - s).cwiseAbs().maxCoeff(), 1e-11);  // 12 digits
    EXPECT_TRUE(model_differences(*opened_by_mujoco(folder.path() / "dog.xml"),
                                  *compile_mjcf(text, file_, MeshDetail::triangles), 0.0)
                    .empty());
    EXPECT_EQ(files.includes()[0].text, robot.files.includes()[0].text);  // defaults: no design
    EXPECT_NE(files.includes()[1].text, robot.files.includes()[1].text);
    EXPECT_NE(files.includes()[2].text, robot.files.includes()[2].text);
    EXPECT_NE(files.main_text(), robot.files.main_text());
  }
}

TEST_F(SplitPuppy, TextOfAnotherRobotIsNotTakenApart) {
  const RobotFiles files = RobotFiles::read(file_);
  EXPECT_THROW(files.with_text(test::read_file(test::puppy_file())), std::logic_error);
  EXPECT_THROW(files.with_text(test::with(files.text(), "<!-- FL -->", "<!-- RL and more -->")),
               std::logic_error);
}

/// Sections that occur in several files, and includes within sections: MuJoCo joins them by its own
/// rules, which hold for the one text as well.
TEST(RobotFiles, SectionsOfSeveralFilesAreJoinedAsMujocoDoes) {
  const TemporaryFolder folder;
  const fs::path main = folder.path() / "main.xml";
  put(main, R"(<?xml version="1.0"?>
<mujoco model="main"><include file="first.xml"/><compiler angle="radian" meshdir="meshes"/>
  <default><geom density="500"/><include file="class.xml"/></default><option timestep="0.003"/>
  <asset><mesh file="tet.stl"/></asset>
  <worldbody><body name="a" pos="1 0 0" euler="0.1 0 0" childclass="red"><freejoint/>
    <geom size="0.1"/>
    <include file="deep/parts.xml"/><geom name="last" size="0.2"/></body></worldbody>
</mujoco>
<!-- behind -->)");
  put(folder.path() / "first.xml", R"(<mujoco model="not this">
<compiler angle="degree" eulerseq="ZYX" meshdir="no"/>
<default><geom density="700" friction="0.3"/>
<default class="blue"><geom rgba="0 0 1 1"/></default></default>
<option timestep="0.004" gravity="0 0 -1"/>
<worldbody><geom name="w" size="1"/></worldbody></mujoco>)");
  put(folder.path() / "class.xml", "<x/>");
  EXPECT_NE(error_message([&] { RobotFiles::read(main); }), "accepted");
  put(folder.path() / "class.xml",
      "<mujocoinclude><default class=\"red\"><geom rgba=\"1 0 0 1\"/></default></mujocoinclude>");
  put(folder.path() / "deep/parts.xml", R"(<mujocoinclude>
<geom type="mesh" mesh="tet" pos="0 0 1"/><body name="b"><joint axis="1 2 3" range="-10 20"/>
<include file="deep/more.xml"/></body></mujocoinclude>)");
  put(folder.path() / "deep/more.xml",
      "<mujocoinclude><geom class=\"blue\" size=\"0.3\"/><site euler=\"90 0 0\"/></mujocoinclude>");
  put(folder.path() / "meshes/tet.stl", test::tetrahedron_stl(0.2f));
  const RobotFiles files = RobotFiles::read(main);
  const ModelPointer stock = opened_by_mujoco(main),
                     ours = compile_mjcf(files.text(), main, MeshDetail::triangles);
  ASSERT_TRUE(stock);
  EXPECT_TRUE(model_differences(*stock, *ours, 0.0).empty());
  EXPECT_EQ(stock->opt.timestep, ours->opt.timestep);
  EXPECT_EQ(stock->opt.gravity[2], ours->opt.gravity[2]);
  ASSERT_EQ(stock->ngeom, ours->ngeom);
  for (int k = 0; k < 4 * stock->ngeom; ++k)
    EXPECT_EQ(stock->geom_rgba[k], ours->geom_rgba[k]) << k;
  for (int k = 0; k < 3 * stock->ngeom; ++k)
    EXPECT_EQ(stock->geom_friction[k], ours->geom_friction[k]) << k;
}

/// A mesh that is not in the main file's folder is looked for beside the included file that names
/// it, and the main file's folder comes first. Copies hold it under its path.
TEST(RobotFiles, MeshesBesideAnIncludedFileAreThoseThatMujocoReads) {
  for (const std::string compiler : {"", "<compiler meshdir=\"shapes\"/>"}) {
    const TemporaryFolder folder;
    const fs::path main = folder.path() / "main.xml";
    const std::string part =
        "<mujocoinclude><asset>" + std::string(R"(<mesh file="near.stl"/><mesh file="both.stl"/>
<mesh name="deep" file="deeper/far.stl"/></asset><worldbody><body><freejoint/>
<geom type="mesh" mesh="near"/><geom type="mesh" mesh="both"/><geom type="mesh" mesh="deep"/>
</body></worldbody></mujocoinclude>)");
    put(main, "<mujoco>" + compiler + "<include file=\"parts/body.xml\"/></mujoco>");
    put(folder.path() / "parts/body.xml", part);
    put(folder.path() / "parts/near.stl", test::tetrahedron_stl(0.1f));
    put(folder.path() / "parts/deeper/far.stl", test::tetrahedron_stl(0.2f));
    put(folder.path() / "parts/both.stl", test::tetrahedron_stl(0.3f));
    put(folder.path() / (compiler.empty() ? "both.stl" : "shapes/both.stl"),
        test::tetrahedron_stl(0.4f));
    const RobotFiles files = RobotFiles::read(main);
    const ModelPointer stock = opened_by_mujoco(main);
    ASSERT_TRUE(stock);
    EXPECT_TRUE(
        model_differences(*stock, *compile_mjcf(files.text(), main, MeshDetail::triangles), 0.0)
            .empty());
    EXPECT_EQ(
        paths(files.assets()),
        (std::vector<std::string>{compiler.empty() ? "both.stl" : "parts/deeper/far.stl",
                                  compiler.empty() ? "parts/deeper/far.stl" : "parts/near.stl",
                                  compiler.empty() ? "parts/near.stl" : "shapes/both.stl"}));
    EXPECT_EQ(files.main_text(), test::read_file(main));
    EXPECT_EQ(test::read_file(folder.path() / "parts/body.xml"), part);
    const RobotFiles copy = files.gathered();
    const TemporaryFolder other;
    put(other.path() / "robot.xml", copy.main_text());
    for (const IncludedFile& included : copy.includes())
      put(other.path() / included.path, included.text);
    for (const AssetFile& asset : copy.assets())
      put(other.path() / asset.path, test::read_file(asset.source));
    EXPECT_TRUE(
        model_differences(*stock, *opened_by_mujoco(other.path() / "robot.xml"), 0.0).empty());
  }
}

void expect_words(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " not in: " << message;
}

int line_in(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  EXPECT_NE(at, std::string::npos) << word;
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
}

int line_of(const fs::path& file, const std::string& word) {
  return line_in(test::read_file(file), word);
}

/// Faults of several kinds, each told at its place: what our checks find, what MuJoCo finds, and
/// what stands behind an included file in the main one.
TEST_F(SplitPuppy, FaultsAreReportedAtTheLineOfTheirFile) {
  const struct {
    const char *file, *good, *bad, *words;
  } faults[] = {
      {"parts/front_left.xml", "name=\"FL_hip\" axis=\"0 1 0\"", "name=\"FL_hip\" axis=\"0 0 0\"",
       "zero axis"},
      {"parts/shank.xml", "name=\"FL_knee\" axis", "type=\"slide\" name=\"FL_knee\" axis",
       "joint 'FL_knee': slide joints"},
      {"parts/shank.xml", "<geom class=\"servo\"", "<geom class=\"swervo\"", "swervo"},
      {"parts/drives.xml", "ankle_servo\" joint=\"HR_ankle\"", "ankle_servo\" joint=\"HR_knee\"",
       "second actuator"},
      {"parts/defaults.xml", "size=\"0.008\"", "size=\"8mm\"", "8mm"},
      {"dog.xml", "name=\"FR_knee\" axis=\"0 1 0\"", "name=\"FR_knee\" axis=\"0 0 0\"",
       "zero axis"},
      {"dog.xml", "file=\"ear.stl\"", "file=\"tail.stl\"", "'assets/tail.stl' is not there"},
      {"dog.xml", "data=\"0.06 0.036 0.096\"", "data=\"0.061 0.036 0.096\"", "measures 0.06"},
  };
  for (const auto& fault : faults) {
    const fs::path file = folder_.path() / fault.file;
    const std::string good = test::read_file(file);
    put(file, test::with(good, fault.good, fault.bad));
    expect_words(
        error_message(file_),
        {file.string() + ":" + std::to_string(line_of(file, fault.bad)) + ": ", fault.words});
    put(file, good);
  }
  EXPECT_EQ(error_message(file_), "accepted");  // control: each was refused for its own fault
}

/// All reasons at once, each in its file.
TEST_F(SplitPuppy, SeveralFaultsAreReportedInTheirFiles) {
  const fs::path shank = folder_.path() / "parts/shank.xml";
  put(shank, test::with(test::read_file(shank), "name=\"FL_knee\" axis",
                        "type=\"slide\" name=\"FL_knee\" axis"));
  put(file_, test::with(test::read_file(file_), "name=\"HR_knee\" axis",
                        "type=\"slide\" name=\"HR_knee\" axis"));
  const std::string message = error_message(file_);
  expect_words(message, {fmt::format("{}:{}: ", shank.string(), line_of(shank, "FL_knee")),
                         fmt::format("\n{}:{}: ", file_.string(), line_of(file_, "HR_knee"))});
}

TEST_F(SplitPuppy, ASceneAroundARobotIsReadLikeIt) {
  const fs::path scene = folder_.path() / "scene.xml";
  test::put(scene,
            "<mujoco><include file=\"dog.xml\"/><worldbody><geom name=\"floor\" type=\"plane\" "
            "size=\"0 0 1\"/></worldbody></mujoco>");
  const RobotModel robot = read_robot(file_), around = read_robot(scene);
  EXPECT_EQ(around.morphology.feet.size(), robot.morphology.feet.size());
  EXPECT_EQ(around.space.size(), robot.space.size());
  EXPECT_EQ(around.space.initial(), robot.space.initial());
  EXPECT_EQ(surroundings_of(*compile_mjcf(around.xml, around.file)),
            std::vector<std::string>{"plane 'floor'"});
}

TEST_F(SplitPuppy, XmlFaultsAreReportedInTheirFile) {
  const fs::path shank = folder_.path() / "parts/shank.xml";
  put(shank, "<mujoco>\n<body>\n</mujoco>");
  expect_words(error_message(file_), {shank.string() + ":", "an element is not closed"});
  put(shank, "<!DOCTYPE x>\n<mujoco><body/></mujoco>");
  expect_words(error_message(file_), {shank.string() + ":1: <!DOCTYPE>"});
  put(shank, "<robot><link/></robot>");
  expect_words(error_message(file_), {shank.string() + ":1: robot: ", "an included URDF"});
  put(shank, "<mujoco>\n</mujoco>");
  expect_words(error_message(file_), {shank.string() + ":1: ", "without elements"});
}

/// A line that is told in the words is one of its file, too.
TEST_F(SplitPuppy, LinesInTheWordsAreThoseOfTheFiles) {
  const RobotFiles files = RobotFiles::read(file_);
  const fs::path shank = folder_.path() / "parts/shank.xml";
  const char *const here = "<body name=\"FR_thigh\"", *const there = "<body name=\"FL_foot\"";
  const InputError error = files.located(
      InputError(file_.string(), line_in(files.text(), here), "body",
                 fmt::format("as in line {} and line {}", line_in(files.text(), there),
                             line_in(files.text(), here))));
  EXPECT_NE(line_in(files.text(), here), line_of(file_, here));  // else this shows nothing
  EXPECT_EQ(std::string(error.what()),
            fmt::format("{}:{}: body: as in line {} of {} and line {}", file_.string(),
                        line_of(file_, here), line_of(shank, there), shank.string(),
                        line_of(file_, here)));
  const InputError other("task.toml", 3, "", "line 4");
  EXPECT_STREQ(files.located(other).what(), other.what());
}

TEST_F(SplitPuppy, DeclarationsGoIntoTheMainFile) {
  std::string dog = test::read_file(file_);
  const std::size_t begin = dog.find("  <custom>"), end = dog.find("</custom>\n");
  put(file_, dog.erase(begin, end + 10 - begin));
  const RobotFiles files = RobotFiles::read(file_);
  const ProposedParameters found = propose_parameters(files.text(), file_);
  EXPECT_GT(found.proposals.size(), 10u);
  put(file_, with_declarations(files.main_text(), file_, found.proposals));
  const RobotModel declared = read_robot(file_);
  EXPECT_EQ(declared.space.size(), static_cast<int>(found.proposals.size()));
  for (std::size_t k = 0; k < files.includes().size(); ++k)
    EXPECT_EQ(declared.files.includes()[k].text, files.includes()[k].text);
}

}  // namespace
}  // namespace legwright
