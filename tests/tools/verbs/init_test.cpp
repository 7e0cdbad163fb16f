// SPDX-License-Identifier: Apache-2.0
// `legwright init --task` of robots on two feet: those that would fall get no task but
// the reason. `legwright init` of URDFs.
#include <gtest/gtest.h>

#include <regex>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/urdf/write_urdf.hpp"
#include "tests/mjcf/robots/flat_biped.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::Outcome;

class InitOnTwoFeet : public testing::Test {
 protected:
  Outcome init(const test::FlatBiped& how, std::vector<std::string> more = {}) const {
    write_file(robot_, test::flat_biped(how));
    fs::remove(task_);
    std::vector<std::string> words{"init", robot_.string(), "--task", task_.string()};
    words.insert(words.end(), more.begin(), more.end());
    return call(words);
  }
  static test::FlatBiped weak() {
    test::FlatBiped how;
    how.limit = 5.0;
    how.kp = 120.0;
    return how;
  }
  static test::FlatBiped pointed() {
    test::FlatBiped how;
    how.foot = test::foot_geoms("ball");
    return how;
  }
  const test::TemporaryFolder folder_;
  const fs::path robot_ = folder_.path() / "robot.xml", task_ = folder_.path() / "task.toml";
};

TEST_F(InitOnTwoFeet, WritesATaskForFlatFeetOnStrongAnkles) {
  const Outcome told = init({});
  ASSERT_EQ(told.code, 0) << told.err;
  const std::string text = read_file(task_);
  for (const char* key : {"swing_height = ", "[servos]\nkp = ", "kd = "})
    EXPECT_TRUE(contains(text, key)) << key << text;
  const Outcome check = call({"check", task_.string()});
  EXPECT_EQ(check.code, 0) << check.err;
}

TEST_F(InitOnTwoFeet, WritesNoneForThoseThatWouldFall) {
  const Outcome weak_ones = init(weak());
  EXPECT_EQ(weak_ones.code, 1);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_TRUE(contains(weak_ones.err, "task.toml is not written: weak ankles")) << weak_ones.err;
  EXPECT_TRUE(contains(weak_ones.err, "has 5;")) << weak_ones.err;
  EXPECT_FALSE(contains(weak_ones.out, "next: legwright optimize")) << weak_ones.out;
  const Outcome points = init(pointed());
  EXPECT_EQ(points.code, 1);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_TRUE(contains(points.err, "is not written: two small feet")) << points.err;
  const Outcome document = init(pointed(), {"--json"});
  EXPECT_EQ(document.code, 1);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_NO_THROW(Json::parse(document.out));
}

TEST_F(InitOnTwoFeet, StillWritesTheirParameters) {
  const Outcome told = init(weak(), {"--write"});
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(contains(read_file(robot_), "legwright/shank_length"));
  EXPECT_FALSE(fs::exists(task_));
}

TEST_F(InitOnTwoFeet, WritesThemAllTheSameWhereTheGaitIsNamed) {
  for (const test::FlatBiped& how : {weak(), pointed()}) {
    const Outcome told = init(how, {"--gait", "walk"});
    EXPECT_EQ(told.code, 0) << told.err;
    ASSERT_TRUE(fs::exists(task_));
    EXPECT_TRUE(contains(read_file(task_), "\"walk\""));
    const Outcome check = call({"check", task_.string()});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_TRUE(contains(check.out + check.err, "weak ankles") ||
                contains(check.out + check.err, "two small feet"))
        << check.out << check.err;
  }
}

/// Rows of footfalls stand as limbs do, whatever the order of the file.
TEST(Check, FootfallsAreInTheOrderOfLimbs) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "task.toml";
  write_file(robot, test::read_file(test::source_path("tests/robots/servo_dog/robot.xml")));
  write_file(task,
             "robot = \"robot.xml\"\n[gait]\nname = \"trot\"\nperiod = 0.5\n[travel]\n"
             "velocity = [0.1, 0.0]\nforward = \"-x\"\n");
  const Outcome told = call({"check", task.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  const std::string rows = told.out.substr(told.out.find("\ngait "));
  std::size_t at = 0;
  for (const char* foot : {"\n  HR_foot", "\n  HL_foot", "\n  FR_foot", "\n  FL_foot"}) {
    const std::size_t next = rows.find(foot);
    ASSERT_NE(next, std::string::npos) << told.out;
    EXPECT_GT(next, at) << told.out;
    at = next;
  }
}

class InitOfUrdf : public testing::Test {
 protected:
  InitOfUrdf() {
    const RobotModel robot = read_robot(test::source_path("tests/robots/courser/robot.xml"));
    write_file(urdf_, urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "").text);
  }
  const test::TemporaryFolder folder_;
  const fs::path urdf_ = folder_.path() / "dog.urdf", robot_ = folder_.path() / "dog.xml",
                 task_ = folder_.path() / "task.toml";
};

TEST_F(InitOfUrdf, TellsWhatItFindsAndWhereMjcfGoes) {
  const Outcome told = call({"init", urdf_.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  for (const char* part :
       {"made     MJCF of this URDF", "12 joints get position servos", "front_thigh_length",
        "the MJCF gets it as keyframe 'legwright'", "dog.urdf -o dog.xml --task task.toml"})
    EXPECT_TRUE(contains(told.out, part)) << part << "\n" << told.out;
  const Outcome json = call({"init", urdf_.string(), "--json"});
  EXPECT_EQ(Json::parse(json.out).at("of_urdf"), true) << json.err;
  EXPECT_FALSE(Json::parse(json.out).at("mended").empty());
}

TEST_F(InitOfUrdf, WritesMjcfThatATaskCanName) {
  const Outcome told =
      call({"init", urdf_.string(), "-o", robot_.string(), "--task", task_.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  const Outcome check = call({"check", task_.string()});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_TRUE(contains(check.out, "front_thigh_length")) << check.out;
  EXPECT_EQ(read_robot(robot_).space.size(), 20);
}

TEST_F(InitOfUrdf, WhereTheTaskCannotBeWrittenTheRobotIsNot) {
  const Outcome told = call(
      {"init", urdf_.string(), "-o", robot_.string(), "--task", (urdf_ / "task.toml").string()});
  EXPECT_EQ(told.code, 3) << told.out << told.err;
  EXPECT_FALSE(fs::exists(robot_));
  write_file(robot_, "mine");
  EXPECT_EQ(call({"init", urdf_.string(), "-o", robot_.string(), "--task", task_.string()}).code,
            3);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_EQ(read_file(robot_), "mine");
}

TEST_F(InitOfUrdf, IsNeverWrittenToAndNoTaskNamesIt) {
  const std::string before = read_file(urdf_);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--write"}, {"--task", task_.string()}, {"-o", urdf_.string()}}) {
    std::vector<std::string> words{"init", urdf_.string()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome told = call(words);
    EXPECT_EQ(told.code, 2) << told.out;
    EXPECT_TRUE(contains(told.err, "is a URDF")) << told.err;
    EXPECT_TRUE(contains(told.err, "-o ")) << told.err;
    EXPECT_EQ(read_file(urdf_), before);
    EXPECT_FALSE(fs::exists(task_));
  }
  write_file(task_,
             "robot = \"dog.urdf\"\n[gait]\nname = \"trot\"\nperiod = 0.5\n[travel]\nvelocity = "
             "[0.1, 0.0]\n");
  const Outcome check = call({"check", task_.string()});
  EXPECT_EQ(check.code, 2);
  EXPECT_TRUE(contains(check.err, "legwright init FILE.urdf -o robot.xml")) << check.err;
}

/// What is recommended has to work.
TEST_F(InitOfUrdf, InThePlaceOfATaskIsToldByTheCommandThatMakesOne) {
  for (const char* verb : {"check", "optimize"}) {
    const Outcome told = call({verb, urdf_.string()});
    EXPECT_EQ(told.code, 2);
    EXPECT_TRUE(contains(told.err, "`legwright init " + urdf_.string() +
                                       " -o dog.xml --task task.toml` writes a first one"))
        << told.err;
  }
  const Outcome folder = call({"init", folder_.path().string()});
  EXPECT_EQ(folder.code, 2);
  EXPECT_TRUE(contains(folder.err, "name the robot's MJCF or URDF file")) << folder.err;
}

/// As CAD programs draw it. What is written is upright, and nothing is left to turn.
TEST_F(InitOfUrdf, OneWithYUpIsTurned) {
  const RobotModel robot = parse_robot(test::strider_with_y_up(), "strider.xml");
  write_file(urdf_, urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "").text);
  const Outcome told =
      call({"init", urdf_.string(), "-o", robot_.string(), "--task", task_.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(told.out.find("turned   y is up in the frame of the trunk 'body'"), 0U) << told.out;
  EXPECT_TRUE(contains(told.out, "6 legs, 18 joints")) << told.out;
  EXPECT_TRUE(contains(read_file(task_), "\"tripod\"")) << read_file(task_);
  const Outcome again = call({"init", robot_.string(), "--json"});
  EXPECT_TRUE(Json::parse(again.out).at("trunk_axes").is_null()) << again.out;
}

/// Strider, whose trunk floats by three slides and three hinges.
std::string strider_on_six_joints() {
  std::string xml = read_file(fs::path(test::source_dir()) / "tests/robots/strider/robot.xml");
  std::string joints;
  for (const char* axis : {"1 0 0", "0 1 0", "0 0 1"})
    joints +=
        "<joint type=\"slide\" axis=\"" + std::string(axis) + "\"/><joint axis=\"" + axis + "\"/>";
  xml.replace(xml.find("<freejoint/>"), 12, joints);
  const std::string free = "0 0 0.115267 1 0 0 0 ";
  return xml.replace(xml.find(free), free.size(), "0 0 0 0 0 0 ");
}

/// A file that is refused without --write, and stays; with it the tree is told, and can be checked.
class InitOfAnotherRoot : public InitOfUrdf {
 protected:
  void expect_mended_on_request(const std::string& given, const char* refusal, const char* begin) {
    write_file(robot_, given);
    const Outcome none = call({"init", robot_.string(), "--task", task_.string()});
    EXPECT_EQ(none.code, 2) << none.out;
    EXPECT_TRUE(contains(none.err, refusal)) << none.err;
    EXPECT_EQ(read_file(robot_), given);
    const Outcome told = call({"init", robot_.string(), "--write", "--task", task_.string()});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_EQ(told.out.find(begin), 0U) << told.out;
    EXPECT_EQ(call({"check", task_.string()}).code, 0);
  }
};

TEST_F(InitOfAnotherRoot, ATrunkThatFloatsBySixJointsGetsAFreeOne) {
  expect_mended_on_request(strider_on_six_joints(), "add --write, which puts it there",
                           "floats   the trunk 'body', by six joints in the file");
  EXPECT_TRUE(contains(read_file(robot_), "<freejoint name=\"root\"/>"));
}

TEST_F(InitOfAnotherRoot, ATrunkThatIsFixedToTheWorldGetsAFreeJoint) {
  std::string given = read_file(fs::path(test::source_dir()) / "tests/robots/strider/robot.xml");
  given = test::with(test::with(given, "<freejoint/>", ""), "0 0 0.115267 1 0 0 0 ", "");
  expect_mended_on_request(given, "which is drawn fixed to the world; add --write",
                           "floats   by a free joint for the trunk 'body'");
}

/// A shell beside the whole leg of the servo dog, which would push it away whatever the gait.
TEST_F(InitOfUrdf, ShapesOfALimbThatAlwaysOverlapMayPass) {
  std::string given = read_file(fs::path(test::source_dir()) / "tests/robots/servo_dog/robot.xml");
  given = test::with(given, "<geom class=\"bone\" fromto=\"0 0 0 0 0 -0.08\"/>",
                     "<geom class=\"bone\" fromto=\"0 0 0 0 0 -0.08\" contype=\"1\"/>");
  given = test::with(given, "size=\"0.1 0.045 0.02\"",
                     "contype=\"1\" conaffinity=\"1\" size=\"0.2 0.066 0.13\"");
  write_file(robot_, given);
  const Outcome told = call({"init", robot_.string(), "--write"});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "'FL_lower' in 'frame' (10 mm); an <exclude>")) << told.out;
  EXPECT_TRUE(contains(read_file(robot_), "<exclude body1=\"frame\" body2=\"FL_lower\"/>"));
  const std::string once = read_file(robot_);
  ASSERT_EQ(call({"init", robot_.string(), "--write"}).code, 0);
  EXPECT_EQ(read_file(robot_), once);
}

TEST_F(InitOfUrdf, ATrunkWithoutANameIsGivenOne) {
  const std::string given =
      test::with(read_file(fs::path(test::source_dir()) / "tests/robots/strider/robot.xml"),
                 "<body name=\"body\"", "<body");
  write_file(robot_, given);
  const Outcome none = call({"init", robot_.string(), "--task", task_.string()});
  EXPECT_EQ(none.code, 2) << none.out;
  EXPECT_TRUE(contains(none.err, "calls it 'trunk'")) << none.err;
  EXPECT_EQ(read_file(robot_), given);
  const Outcome told = call({"init", robot_.string(), "--write", "--task", task_.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(read_file(robot_), "name=\"trunk\""));
  EXPECT_EQ(call({"check", task_.string()}).code, 0);
}

/// A robot beside a ball, in the file that its scene includes.
TEST_F(InitOfUrdf, WhatAnIncludedFileHasIsLeftAsItIs) {
  const fs::path scene = folder_.path() / "around.xml";
  write_file(scene,
             "<mujoco><include file=\"" + robot_.filename().string() +
                 "\"/><worldbody><body pos=\"1 0 .1\"><freejoint/><geom size=\".05\" mass=\".1\"/>"
                 "</body></worldbody></mujoco>");
  const auto without_keyframe = [](std::string xml) {
    return xml.erase(xml.find("<keyframe>"), xml.find("</keyframe>") + 11 - xml.find("<keyframe>"));
  };
  write_file(robot_, without_keyframe(read_file(fs::path(test::source_dir()) /
                                                "tests/robots/strider/robot.xml")));
  const Outcome plain = call({"init", scene.string()});
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_FALSE(contains(plain.out, "named    the trunk")) << "the ball is none";
  const char* const inertial = R"(pos="0 0 .01" quat="12 0 0 5" diaginertia=".00562 .0185 .02312")";
  write_file(robot_, without_keyframe(test::strider_in_axes("12 0 0 5", inertial)));
  const Outcome askew = call({"init", scene.string()});
  EXPECT_EQ(askew.code, 0) << askew.err;
  EXPECT_TRUE(contains(askew.out, "44.8 degrees about z")) << askew.out;
  EXPECT_TRUE(contains(askew.out, "ahead, left and right are along its axes")) << askew.out;
  EXPECT_EQ(call({"init", robot_.string(), "--write"}).code, 0) << "which is turned by itself";
}

TEST_F(InitOfUrdf, NoTaskIsWrittenForAnMjcfThatHasToBeTurnedFirst) {
  const std::string drawn = test::strider_with_y_up();
  write_file(robot_, drawn);
  const Outcome told = call({"init", robot_.string(), "--task", task_.string()});
  EXPECT_EQ(told.code, 2) << told.out;
  EXPECT_TRUE(contains(told.err, "add --write, which turns the trunk's frame")) << told.err;
  EXPECT_EQ(read_file(robot_), drawn);
  EXPECT_EQ(call({"init", robot_.string(), "--write", "--task", task_.string()}).code, 0);
  EXPECT_TRUE(contains(read_file(robot_), "<frame quat=\"1 1 0 0\">"));
  const std::string turn = "warning y is up in the frame of the trunk 'body'";
  EXPECT_FALSE(contains(call({"check", task_.string()}).out, turn));
  write_file(robot_, test::with(drawn, "0.115267 1 0 0 0 ", "0.115267 1 1 0 0 "));
  const Outcome check = call({"check", task_.string()});
  EXPECT_TRUE(contains(check.out, turn)) << check.out << check.err;
  EXPECT_TRUE(contains(check.out, "`legwright init dog.xml --write` turns")) << check.out;
}

std::string without_ranges(std::string urdf) {
  for (std::size_t at; (at = urdf.find(" lower=")) != std::string::npos;)
    urdf.erase(at, urdf.find(" effort=", at) - at);
  return urdf;
}

/// A URDF takes no keyframe: the message says what does, and in which order.
TEST_F(InitOfUrdf, OneThatDoesNotStandIsToldHowItsMjcfGetsAPose) {
  write_file(urdf_, test::with(without_ranges(read_file(urdf_)), "<link name=\"base\">",
                               "<link name=\"base\"><collision><geometry><box size=\"0.2 0.2 3\"/>"
                               "</geometry></collision>"));
  const Outcome told =
      call({"init", urdf_.string(), "-o", robot_.string(), "--task", task_.string()});
  EXPECT_EQ(told.code, 2) << told.out;
  for (const char* part : {"the same command without --task writes the MJCF that takes it",
                           "then the angles of FR_hip_joint, FR_thigh_joint"})
    EXPECT_TRUE(contains(told.err, part)) << part << "\n" << told.err;
  EXPECT_FALSE(fs::exists(robot_));
  EXPECT_EQ(call({"init", urdf_.string(), "-o", robot_.string()}).code, 0);
}

/// What is refused is told in words of the file that the user has, with what else may be why.
TEST_F(InitOfUrdf, WithoutCollisionShapesIsToldInItsOwnWords) {
  const std::string urdf =
      std::regex_replace(read_file(urdf_), std::regex("<collision[^]*?</collision>"), "");
  write_file(urdf_, urdf);
  const Outcome told = call({"init", urdf_.string()});
  EXPECT_EQ(told.code, 2) << told.out;
  for (const char* part : {"link 'FR_calf': ends a leg without a foot; add <collision>",
                           "<visual> shapes touch nothing"})
    EXPECT_TRUE(contains(told.err, part)) << part << "\n" << told.err;
  for (const char* part : {"<geom ", "contype", "body '", "inertial"})
    EXPECT_FALSE(contains(told.err, part)) << part << "\n" << told.err;
  write_file(urdf_, std::regex_replace(urdf, std::regex("(<inertial>\\s*<origin xyz=\")[^\"]*"),
                                       "$010 0 2"));
  EXPECT_TRUE(contains(call({"init", urdf_.string()}).err, "m from the middle of its shape"));
}

TEST_F(InitOfUrdf, FaultsOfTheMjcfThatIsMadeHaveNoLineOfTheUrdf) {
  write_file(urdf_, test::with(read_file(urdf_), "<mass value=", "<mass value=\"0\" was="));
  const Outcome told = call({"init", urdf_.string()});
  EXPECT_EQ(told.code, 2) << told.out;
  EXPECT_FALSE(contains(told.err, ", line ")) << told.err;
  EXPECT_TRUE(contains(told.err, "dog.urdf: ")) << told.err;
}

}  // namespace
}  // namespace legwright
