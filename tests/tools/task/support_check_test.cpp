// SPDX-License-Identifier: Apache-2.0
#include "tools/task/support_check.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/source_tree.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

std::string told(const RobotModel& robot, const std::string& gait) {
  const fs::path place = robot.file.parent_path() / "test.toml";
  return unsupported_stance(
      make_task(parse_task_file("robot = \"robot.xml\"\n[gait]\nname = \"" + gait +
                                    "\"\nperiod = 0.5\n[travel]\nvelocity = [0.1, 0.0]\n",
                                place),
                robot),
      robot);
}

RobotModel example(const char* name) { return read_robot(test::kExamples / name / "robot.xml"); }

/// The trunk's weight moved forward, in the plan's own numbers.
RobotModel with_weight_ahead(RobotModel robot, double metres) {
  for (PointMass& point : robot.morphology.links[0].masses) point.position.constant.x() += metres;
  return robot;
}

TEST(UnsupportedStance, NothingIsSaidOfGaitsThatCarryTheRobot) {
  EXPECT_EQ(told(example("hexapod"), "tripod"), "");
  for (const char* gait : {"walk", "trot", "pace", "bound"})
    EXPECT_EQ(told(example("quadruped"), gait), "") << gait;
}

TEST(UnsupportedStance, ATripodWithItsWeightBeyondTheFeetIsTold) {
  const std::string words = told(with_weight_ahead(example("hexapod"), 0.5), "tripod");
  EXPECT_NE(words.find("outside of their support"), std::string::npos) << words;
}

TEST(UnsupportedStance, ATrotIsJudgedByItsLineAndAPaceNotAtAll) {
  const RobotModel robot = with_weight_ahead(example("quadruped"), 0.15);
  EXPECT_NE(told(robot, "trot").find("centre of mass"), std::string::npos);
  EXPECT_EQ(told(robot, "pace"), "");
}

}  // namespace
}  // namespace legwright
