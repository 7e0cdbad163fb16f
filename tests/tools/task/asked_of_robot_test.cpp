// SPDX-License-Identifier: Apache-2.0
// What a task file asks of its robot, and the robot does not have: one list, in the robot's units.
#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/read/servos.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/task/problem.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kPuppy;

const RobotModel& small_puppy() {
  static const RobotModel robot = read_robot(kPuppy / "robot.xml");
  return robot;
}

std::string refusal_of(const RobotModel& robot, const std::string& rest) {
  try {
    const fs::path file = kPuppy / "test.toml";
    const std::string text = "robot = \"robot.xml\"\n" + rest;
    make_problem(parse_task_set(text, file), robot);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Names in any table that the robot does not have, and numbers that it does not take: one list.
TEST(AskedOfRobot, AllThatTheRobotDoesNotHaveIsToldAtOnceInTheOrderOfTheFile) {
  const std::string told = refusal_of(small_puppy(), R"([travel]
velocity = [0.1, 0.0]
[gait]
name = "trot"
period = 0.5
[style.foot_heights]
tail = [0.01, 0.02]
nose = [0.01, 0.02]
[style.joint_angles]
FL_tail = [0.1]
FL_hip = [9.0]
[weights]
ballance = 1.0
[limits]
limb_pairs = [["FL_toe", "FR_toe"]]
[design]
freeze = ["front_tail", "hind_tail"]
)");
  std::size_t at = 0;
  int lines = 0;
  for (const char* part :
       {":8: style.foot_heights.tail", ":9: style.foot_heights.nose",
        ":11: style.joint_angles.FL_tail", ":12: style.joint_angles.FL_hip",
        ":14: weights.ballance", ":16: limits.limb_pairs: no link or foot is named 'FL_toe'",
        ":16: limits.limb_pairs: no link or foot is named 'FR_toe'",
        ":18: design.freeze: the robot has no design parameter 'front_tail'",
        ":18: design.freeze: the robot has no design parameter 'hind_tail'"}) {
    const std::size_t found = told.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << " not in order in:\n" << told;
    at = found;
    ++lines;
  }
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n') + 1, lines) << told;
}

/// A robot whose file is in degrees is told of in degrees.
TEST(AskedOfRobot, AnglesAreToldAsTheRobotsFileHasThem) {
  RobotModel robot = small_puppy();
  const std::string rest = R"([travel]
velocity = [0.1, 0.0]
[gait]
name = "trot"
period = 0.5
[style.joint_angles]
FL_knee = [9.0]
)";
  EXPECT_EQ(refusal_of(robot, rest).find("degrees"), std::string::npos) << refusal_of(robot, rest);
  robot.in_degrees = true;
  EXPECT_NE(refusal_of(robot, rest).find("rad ("), std::string::npos) << refusal_of(robot, rest);
  EXPECT_NE(refusal_of(robot, rest).find(" degrees)"), std::string::npos);
  for (Servo& servo : robot.servos) servo.kp *= 0.02;
  set_gains(robot.servos, robot.space.initial(), robot.morphology);
  const auto soft = [&](bool in_degrees) {
    robot.in_degrees = in_degrees;
    for (const std::string& warning :
         task_warnings(make_task(read_task_file(kPuppy / "sideways.toml"), robot), robot))
      if (warning.starts_with("soft servos")) return warning;
    return std::string();
  };
  EXPECT_NE(soft(true).find(" degrees (kp"), std::string::npos) << soft(true);
  EXPECT_NE(soft(false).find(" rad (kp"), std::string::npos) << soft(false);
}

}  // namespace
}  // namespace legwright
