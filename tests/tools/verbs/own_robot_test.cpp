// SPDX-License-Identifier: Apache-2.0
// What a newcomer does with a robot of their own: init, optimize, validate, without a hand edit or
// a weight. All of tests/robots: tests/robots/walk.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/long_tests.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/verbs/judged_example.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::Outcome;

fs::path copy_of(const std::string& robot, const fs::path& folder) {
  fs::copy(fs::path(test::source_dir()) / "tests/robots" / robot,
           folder);  // with what it includes
  return folder / "robot.xml";
}

/// init, optimize, validate: what a newcomer types. @param gait of the first task; empty: the usual
/// one
void expect_first_task_passes(const fs::path& robot, const std::string& gait = "") {
  const fs::path task = robot.parent_path() / "task.toml", run = robot.parent_path() / "run";
  std::vector<std::string> words{"init", robot.string(), "--write", "--task", task.string()};
  if (!gait.empty()) words.insert(words.end(), {"--gait", gait});
  const Outcome told = call(words);
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "legwright optimize")) << told.out;
  EXPECT_FALSE(contains(read_file(task), "weights"));
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures",
                  "--no-certificate", "--no-reasons", "--quiet"})
                .code,
            0);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, 0) << verdict.out << verdict.err;
}

/// A disc with `count` legs of three joints all around it, the first one ahead.
std::string star(int count) {
  std::string legs, servos, pose;
  for (int k = 0; k < count; ++k) {
    const double turn = 2.0 * M_PI * k / count;
    legs += fmt::format(
        R"(<body name="coxa{0}" pos="{1:.6f} {2:.6f} 0" euler="0 0 {3:.6f}">
          <joint name="yaw{0}" axis="0 0 1" range="-0.8 0.8"/>
          <inertial pos="0.02 0 0" mass="0.1" diaginertia="2e-5 4e-5 4e-5"/>
          <body name="femur{0}" pos="0.045 0 0">
            <joint name="lift{0}" axis="0 1 0" range="-1.4 1.2"/>
            <inertial pos="0.05 0 0" mass="0.15" diaginertia="3e-5 2e-4 2e-4"/>
            <body name="tibia{0}" pos="0.09 0 0">
              <joint name="knee{0}" axis="0 1 0" range="-0.8 1.7"/>
              <inertial pos="0 0 -0.06" mass="0.07" diaginertia="1.5e-4 1.5e-4 1e-5"/>
              <geom name="tip{0}" size="0.01" pos="0 0 -0.14"/>
            </body>
          </body>
        </body>)",
        k, 0.09 * std::cos(turn), 0.09 * std::sin(turn), turn);
    for (const char* joint : {"yaw", "lift", "knee"})
      servos += fmt::format(R"(<position name="{0}{1}" joint="{0}{1}"/>)", joint, k);
    pose += " 0 -0.5 0.5";
  }
  return fmt::format(
      R"(<mujoco model="star"><compiler angle="radian" autolimits="true"/>
      <default><joint damping="0.03" armature="0.003"/>
        <position kp="150" kv="2" forcerange="-6 6"/></default>
      <worldbody><body name="disc" pos="0 0 0.107"><freejoint/>
        <inertial pos="0 0 0.005" mass="2" diaginertia="0.006 0.006 0.011"/>{}</body></worldbody>
      <actuator>{}</actuator>
      <keyframe><key name="home" qpos="0 0 0.107 1 0 0 0{}"/></keyframe></mujoco>
)",
      legs, servos, pose);
}

class OwnRobot : public testing::TestWithParam<const char*> {};

/// By tests/robots/walk where that has just made its run for tests and pages (tools/test).
TEST_P(OwnRobot, WalksByItsFirstTask) {
  if (const fs::path made = test::made_examples(); !made.empty()) {
    const fs::path robot = made / "robots" / GetParam();
    int optimize = -1, validate = -1;  // exit codes
    std::ifstream(robot / "run.codes") >> optimize >> validate;
    EXPECT_EQ(optimize, 0) << robot << ": of tests/robots/walk --verdicts";
    EXPECT_EQ(validate, 0) << robot;
    EXPECT_FALSE(contains(read_file(robot / "task.toml"), "weights"));
    return;
  }
  const test::TemporaryFolder folder;
  expect_first_task_passes(copy_of(GetParam(), folder.path()));
}

INSTANTIATE_TEST_SUITE_P(Robots, OwnRobot,
                         testing::Values("lurcher", "servo_dog", "strider", "ox", "octopod",
                                         "porter"));

class OctopodGait : public testing::TestWithParam<const char*> {};

TEST_P(OctopodGait, WalksOnEightFeet) {
  LEGWRIGHT_LONG_TEST();
  const test::TemporaryFolder folder;
  expect_first_task_passes(copy_of("octopod", folder.path()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Library, OctopodGait, testing::Values("ripple", "wave"));

class Star : public testing::TestWithParam<int> {};

TEST_P(Star, WalksOnAnOddNumberOfFeetByAWave) {
  if (GetParam() > 5) {
    LEGWRIGHT_LONG_TEST();
  }
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "star.xml";
  write_file(robot, star(GetParam()));
  expect_first_task_passes(robot);
}

INSTANTIATE_TEST_SUITE_P(Odd, Star, testing::Values(5, 7));

TEST(OwnRobotThatFacesLeft, WalksToWhereItFaces) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "strider.xml";
  write_file(robot, test::strider_to_the_left());
  expect_first_task_passes(robot);
  EXPECT_TRUE(contains(read_file(folder.path() / "task.toml"), "forward = \"+y\""));
  const Json run = Json::parse(read_file(folder.path() / "run/run.json"));
  EXPECT_EQ(run["task"]["forward"], "+y");
  EXPECT_EQ(run["task"]["velocity"][0], 0.0);
  EXPECT_GT(run["task"]["velocity"][1], 0.2);
  EXPECT_LT(run["final_F"], 1.6) << "1.517 with the pattern of a robot that faces there";
  const Json verdict = Json::parse(read_file(folder.path() / "run/result/verdict.json"));
  EXPECT_TRUE(contains(verdict["result"]["line"], "tripod forward at"));
}

TEST(OwnRobotInit, WritesParametersButNoTaskWhereThereIsNoGait) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "star.xml", task = folder.path() / "task.toml";
  write_file(robot, star(3));
  const Outcome studied = call({"init", robot.string()});
  EXPECT_EQ(studied.code, 0) << studied.err;
  EXPECT_TRUE(contains(studied.out, "--write ")) << studied.out;
  EXPECT_FALSE(contains(studied.out, "--task")) << "what would be refused is not proposed";
  const Outcome named =
      call({"init", robot.string(), "--write", "--task", task.string(), "--gait", "wave"});
  EXPECT_EQ(named.code, 2);
  EXPECT_FALSE(contains(read_file(robot), "legwright/")) << "nothing half-written";

  const Outcome told = call({"init", robot.string(), "--write", "--task", task.string()});
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(contains(told.err, "touchdown = [0, 0.33, 0.67]")) << told.err;
  EXPECT_TRUE(contains(read_file(robot), "legwright/"));
  EXPECT_FALSE(fs::exists(task));
  write_file(task,
             "robot = \"star.xml\"\n[gait]\nperiod = 1.0\ntouchdown = [0, 0.33, 0.67]\n"
             "duty = 0.83\n[travel]\nvelocity = [0.02, 0.0]\n");
  const Outcome check = call({"check", task.string()});  // what it told to write is accepted
  EXPECT_EQ(check.code, 0) << check.err;
}

TEST(OwnRobotInit, TellsWhatTheFileDeclaresByOtherNames) {
  const std::string puppy = (test::kExamples / "piston_puppy/robot.xml").string();
  const Outcome told = call({"init", puppy});
  EXPECT_TRUE(contains(told.out, "declared  by other names: front_thigh_length (thigh_length),"))
      << told.out;
  EXPECT_FALSE(contains(told.out, "nearly this direction")) << told.out;
  EXPECT_TRUE(contains(told.out, "12 more design parameters could be added:")) << told.out;
  const Outcome biped = call({"init", (test::kExamples / "biped/robot.xml").string()});
  EXPECT_TRUE(contains(biped.out, "left out  foot_length\n          the foot is a round sole"))
      << "other reasons are told: " << biped.out;
}

TEST(OwnRobotInit, TellsTheTreeTheTableAndTheNextCommand) {
  const test::TemporaryFolder folder;
  const fs::path robot = copy_of("octopod", folder.path());
  const Outcome told = call({"init", robot.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  const std::string& out = told.out;
  const std::size_t tree = out.find("trunk hull\n  row 1 of 4, pair, left | right\n"),
                    joint = out.find("    L1_swing | R1_swing  yaw "),
                    servo = out.find("18 N m     kp 400 N m/rad"),
                    foot =
                        out.find("L1_foot | R1_foot    foot     ball of 14 mm at 0.489, +-0.309"),
                    table = out.find("38 design parameters proposed:\n  name "),
                    row = out.find("m    stretch link: L1_femur R1_femur\n"),
                    next = out.find("next: legwright init");
  for (const std::size_t place : {tree, joint, servo, foot, table, row, next})
    ASSERT_NE(place, std::string::npos) << out;
  EXPECT_TRUE(tree < joint && joint < servo && servo < foot && foot < table && table < row &&
              row < next)
      << out;
  ASSERT_EQ(call({"init", robot.string(), "--write"}).code, 0);
  const Outcome again = call({"init", robot.string()});
  EXPECT_TRUE(contains(again.out, "declared  38: front_coxa_length,")) << again.out;
  EXPECT_FALSE(contains(again.out, "0 design parameters")) << again.out;
  EXPECT_FALSE(contains(again.out, "--write")) << "there is nothing to write: " << again.out;
}

/// The courser with a wide trunk, whose thighs hang 13 mm beside it.
void expect_clear_of_trunk(bool clear) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "task.toml",
                 run = folder.path() / "run";
  std::string xml = read_file(fs::path(test::source_dir()) / "tests/robots/courser/robot.xml");
  const std::string slim = "size=\"0.18 0.045 0.055\"";
  ASSERT_NE(xml.find(slim), std::string::npos);
  write_file(robot, xml.replace(xml.find(slim), slim.size(), "size=\"0.21 0.1 0.055\""));
  ASSERT_EQ(call({"init", robot.string(), "--write", "--task", task.string()}).code, 0);
  if (!clear) {
    const std::string text = read_file(task) + "\n[weights]\nlimb_clearance = 0.0\n";
    fs::remove(task);
    write_file(task, text);
  }
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--quiet",
                  "--plan-only"})
                .code,
            0);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, clear ? 0 : 1) << verdict.out << verdict.err;
  EXPECT_EQ(contains(verdict.out, "touches itself"), !clear) << verdict.out;
  const Json overridden =
      Json::parse(read_file(run / "result/verdict.json"))["overridden"]["options"];
  ASSERT_EQ(overridden.size(), 1u);
  EXPECT_EQ(overridden[0], (Json{{"name", "impratio"}, {"file", "100"}, {"scene", "10"}}));
}

TEST(OwnRobotBesideItsTrunk, KeepsItsThighsClearOfIt) { expect_clear_of_trunk(true); }

TEST(OwnRobotBesideItsTrunk, DrivesItsThighsIntoItWithoutLimbClearance) {
  LEGWRIGHT_LONG_TEST();
  expect_clear_of_trunk(false);
}

TEST(OwnRobotInit, WritesAPoseForARobotWhoseFileHasNone) {
  const test::TemporaryFolder folder;
  const fs::path robot = copy_of("lurcher", folder.path() / "lurcher"),
                 task = folder.path() / "task.toml";
  const std::string text = read_file(robot);
  const Outcome told = call({"init", robot.string()});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "outside of its range")) << told.out;
  EXPECT_TRUE(contains(told.out, "--write adds it as keyframe 'legwright'")) << told.out;
  const Outcome without = call({"init", robot.string(), "--task", task.string()});
  EXPECT_EQ(without.code, 2);
  EXPECT_TRUE(contains(without.err, "add --write")) << without.err;
  EXPECT_EQ(read_file(robot), text);
  EXPECT_FALSE(fs::exists(task));
  EXPECT_EQ(call({"init", robot.string(), "--write", "--task", task.string()}).code, 0);
  EXPECT_TRUE(contains(read_file(robot), "<key name=\"legwright\" qpos=\"0 0 "));
  EXPECT_EQ(call({"check", task.string()}).code, 0);
  const std::string written = read_file(robot);
  EXPECT_EQ(call({"init", robot.string(), "--write"}).code, 0);  // nothing to add
  EXPECT_EQ(read_file(robot), written);
}

TEST(OwnRobotInit, WritesNothingForARobotThatDoesNotStand) {
  const test::TemporaryFolder folder;
  std::string text = read_file(fs::path(test::source_dir()) / "tests/robots/servo_dog/robot.xml");
  const std::string before = text;
  const std::string box =
      "size=\"0.1 0.045 0.02\"";  // so high that no pose lifts it off the ground
  ASSERT_NE(text.find(box), std::string::npos);
  text.replace(text.find(box), box.size(), "size=\"0.1 0.045 0.2\" contype=\"1\"");
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "task.toml";
  write_file(robot, text);
  const Outcome told = call({"init", robot.string(), "--write", "--task", task.string()});
  EXPECT_EQ(told.code, 2);
  EXPECT_TRUE(contains(told.err, "does not stand in its home pose")) << told.err;
  EXPECT_TRUE(contains(told.err, "keyframe named home")) << told.err;
  EXPECT_EQ(read_file(robot), text);
  EXPECT_FALSE(fs::exists(task));
  const Outcome only_told = call({"init", robot.string()});
  EXPECT_EQ(only_told.code, 0);
  EXPECT_TRUE(contains(only_told.out, "does not stand in its home pose")) << only_told.out;
  write_file(robot, before);
  EXPECT_EQ(call({"init", robot.string(), "--write", "--task", task.string()}).code, 0);  // twin
}

/// Files of this process and its children may have so many bytes, while it lives: beyond, writing
/// fails as on a full disk.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST(OwnRobotOptimize, ARunThatIsGivenUpSaysSo) {
  const test::TemporaryFolder folder;
  const fs::path robot = copy_of("servo_dog", folder.path()), task = folder.path() / "task.toml",
                 run = folder.path() / "run";
  ASSERT_EQ(call({"init", robot.string(), "--write", "--task", task.string()}).code, 0);
  Outcome told;
  {
    const FileLimit limit(24 * 1024);  // inputs and run.json have less, a scene with its plan more
    told = call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-certificate",
                 "--quiet", "--plan-only", "--max-iterations", "2"});
  }
  ASSERT_EQ(told.code, 3) << told.err;
  const Json after = read_json(run / "run.json");
  EXPECT_EQ(after["status"], "failed");
  EXPECT_TRUE(contains(after["failure"].get<std::string>(), "cannot write"));
}

TEST(OwnRobotInit, OverwritesNoTask) {
  const test::TemporaryFolder folder;
  const fs::path robot = copy_of("servo_dog", folder.path()), task = folder.path() / "task.toml";
  const std::string before = read_file(robot);
  write_file(task, "mine");
  EXPECT_EQ(call({"init", robot.string(), "--write", "--task", task.string()}).code, 3);
  EXPECT_EQ(read_file(task), "mine");
  EXPECT_EQ(read_file(robot), before) << "nothing half-written";
}

TEST(OwnRobotInit, RefusesAGaitOfOtherFeetAndAGaitWithoutATask) {
  const test::TemporaryFolder folder;
  const fs::path robot = copy_of("servo_dog", folder.path()), task = folder.path() / "task.toml";
  const Outcome tripod =
      call({"init", robot.string(), "--task", task.string(), "--gait", "tripod"});
  EXPECT_EQ(tripod.code, 2);
  EXPECT_TRUE(contains(tripod.err, "4 feet")) << tripod.err;
  EXPECT_FALSE(fs::exists(task));
  EXPECT_EQ(call({"init", robot.string(), "--gait", "trot"}).code, 2);
}

}  // namespace
}  // namespace legwright
