// SPDX-License-Identifier: Apache-2.0
// What a newcomer does with a robot of their own: init, optimize, validate, without a hand edit or a weight. All six:
// tests/robots/walk.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::Outcome;

fs::path copy_of(const std::string& robot, const fs::path& folder) {
  const fs::path file = folder / "robot.xml";
  fs::copy_file(fs::path(LEGWRIGHT_SOURCE_DIR) / "tests/robots" / robot / "robot.xml", file);
  return file;
}

class OwnRobot : public testing::TestWithParam<const char*> {};

TEST_P(OwnRobot, WalksByItsFirstTask) {
  const test::TemporaryFolder folder;
  const fs::path robot = copy_of(GetParam(), folder.path()), task = folder.path() / "task.toml",
                 run = folder.path() / "run";
  const Outcome told = call({"init", robot.string(), "--write", "--task", task.string()});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "legwright optimize")) << told.out;
  EXPECT_FALSE(contains(read_file(task), "weights"));
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--quiet"}).code,
            0);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, 0) << verdict.out << verdict.err;
}

INSTANTIATE_TEST_SUITE_P(Robots, OwnRobot, testing::Values("servo_dog", "strider", "ox"));

/// The courser with a wide trunk, whose thighs hang 13 mm beside it.
void expect_clear_of_trunk(bool clear) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "task.toml",
                 run = folder.path() / "run";
  std::string xml = read_file(fs::path(LEGWRIGHT_SOURCE_DIR) / "tests/robots/courser/robot.xml");
  const std::string slim = "size=\"0.18 0.045 0.055\"";
  ASSERT_NE(xml.find(slim), std::string::npos);
  write_file(robot, xml.replace(xml.find(slim), slim.size(), "size=\"0.21 0.1 0.055\""));
  ASSERT_EQ(call({"init", robot.string(), "--write", "--task", task.string()}).code, 0);
  if (!clear) {
    const std::string text = read_file(task) + "\n[weights]\nlimb_clearance = 0.0\n";
    fs::remove(task);
    write_file(task, text);
  }
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--quiet"}).code,
            0);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, clear ? 0 : 1) << verdict.out << verdict.err;
  EXPECT_EQ(contains(verdict.out, "touches itself"), !clear) << verdict.out;
}

TEST(OwnRobotBesideItsTrunk, KeepsItsThighsClearOfIt) { expect_clear_of_trunk(true); }

TEST(OwnRobotBesideItsTrunk, DrivesItsThighsIntoItWithoutLimbClearance) {
  expect_clear_of_trunk(false);
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
