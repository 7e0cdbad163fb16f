// SPDX-License-Identifier: Apache-2.0
// One knee that differs from the others, as where a sign or a range of a file is wrong or missing.
#include "mjcf/propose/odd_joints.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"

namespace legwright {
namespace {

/// Servo dog with other words for some of its joints' own.
std::string dog(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string xml = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  for (const auto& [from, to] : changes) xml = test::with(xml, from, to);
  return xml;
}

std::string knee(const std::string& leg, const std::string& words) {
  return "<joint name=\"" + leg + "_knee\" " + words + "/>";
}

std::pair<std::string, std::string> with_knee(const std::string& leg, const std::string& words) {
  return {knee(leg, "range=\"-2.2 0.4\""), knee(leg, words)};
}

std::vector<std::string> told_of(const std::string& xml) {
  return odd_joints(parse_robot(xml, "dog.xml"));
}

TEST(OddJoints, OfRobotsAsTheyAreThereAreNone) {
  for (const auto& file : test::taken_robots()) {
    if (file.parent_path().filename() == "lurcher") continue;  // has no pose to be read in
    EXPECT_TRUE(odd_joints(read_robot(file)).empty()) << file << odd_joints(read_robot(file))[0];
    EXPECT_EQ(unlimited_torques(read_robot(file)), "") << file;
    EXPECT_EQ(overdamped_joints(read_robot(file)), "") << file;
  }
  for (const char* name : {"puppy", "hexapod", "biped", "quadruped", "piston_puppy"}) {
    const RobotModel robot = parse_robot(test::example_robot(name), name);
    EXPECT_TRUE(odd_joints(robot).empty()) << name;
    EXPECT_EQ(unlimited_torques(robot), "") << name;
    EXPECT_EQ(overdamped_joints(robot), "") << name;
  }
}

TEST(OddJoints, AKneeAboutTheOtherWayIsNamed) {
  const std::vector<std::string> told =
      told_of(dog({with_knee("HR", "axis=\"0 -1 0\" range=\"-2.2 0.4\""),
                   {"  0.6 -1.15\"", "  -0.6 -1.15\""}}));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0],
            "joint 'HR_knee' turns about 0 -1 0 of its body and bends its leg the other way than "
            "FL_knee, FR_knee, HL_knee ('HL_knee' about 0 1 0): turn the sign of its axis, or of "
            "its range, if that is not meant");
}

/// Axis and range together tell the way; knees of two pairs may bend to each other.
TEST(OddJoints, OtherSignsOfTheSameWayAndOtherBuildsAreNone) {
  const std::string home = "0.6 -1.15  0.6 -1.15  0.6 -1.15  0.6 -1.15";
  EXPECT_TRUE(told_of(dog({with_knee("FR", "axis=\"0 -1 0\" range=\"-0.4 2.2\""),
                           {home, "0.6 -1.15  0.6 1.15  0.6 -1.15  0.6 -1.15"}}))
                  .empty());
  EXPECT_TRUE(told_of(dog({with_knee("HL", "range=\"-0.4 2.2\""),
                           with_knee("HR", "range=\"-0.4 2.2\""),
                           {home, "0.6 -1.15  0.6 -1.15  -0.6 1.15  -0.6 1.15"}}))
                  .empty());
  EXPECT_TRUE(told_of(dog({with_knee("HR", "range=\"-2.2 0.3\"")})).empty());
}

TEST(OddJoints, AMissingRangeIsTold) {
  const std::vector<std::string> told = told_of(dog({with_knee("FR", "")}));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0],
            "joint 'FR_knee' has no range, those in its place in the other legs have (FL_knee, "
            "HL_knee, HR_knee; FL_knee: -2.2 to 0.4 rad): any angle is planned for it; write its "
            "range");
  EXPECT_TRUE(told_of(dog({with_knee("FR", ""), with_knee("FL", "")})).empty());
  const std::vector<std::string> alone =
      told_of(dog({with_knee("FR", ""), with_knee("FL", ""), with_knee("HL", "")}));
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0],
            "joint 'HR_knee' has a range (-2.2 to 0.4 rad), those in its place in the other legs "
            "have none (FL_knee, FR_knee, HL_knee); write theirs, or take it out, if that is not "
            "meant");
}

TEST(OddJoints, MotorsWithoutLimitAreTold) {
  const std::string free =
      unlimited_torques(parse_robot(dog({{" forcerange=\"-2 2\"", ""}}), "dog.xml"));
  EXPECT_EQ(free.rfind("8 motors (FL_shoulder, FL_knee, FR_shoulder and 5 more) without a torque "
                       "limit",
                       0),
            0u)
      << free;
}

TEST(OddJoints, DampingThatTakesAllThatMotorsGiveIsTold) {
  const auto damped = [](const char* words) {
    return overdamped_joints(parse_robot(dog({{"damping=\"0.01\"", words}}), "dog.xml"));
  };
  EXPECT_EQ(damped("damping=\"0.8\""), "") << "2 N m less dry friction turn it at 2.5 rad/s";
  const std::string told = damped("damping=\"4\"");
  EXPECT_NE(told.find("(FL_shoulder, FL_knee, FR_shoulder and 5 more): that of joint 'FL_shoulder' "
                      "is 4 N m s/rad, so that its motor of 2 N m, less 0.01 N m of dry friction, "
                      "turns it at 0.5 rad/s at most"),
            std::string::npos)
      << told;
  const RobotModel robot = parse_robot(dog({}), "dog.xml");
  EXPECT_EQ(overdamped_joints(robot), "");
  EXPECT_NE(overdamped_joints(robot, 0.02), "") << "a task may ask for weaker motors";
}

}  // namespace
}  // namespace legwright
