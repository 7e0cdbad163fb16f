// SPDX-License-Identifier: Apache-2.0
#include "mjcf/rewrite_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mjcf/text_scan.hpp"
#include "mjcf/verify.hpp"
#include "tests/mjcf/point_mass_robot.hpp"
#include "tests/mjcf/robots.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// The text with the values of these attributes blanked, to compare everything else.
std::string blanked(const std::string& text, const std::set<std::string>& attributes) {
  std::string out;
  std::size_t copied = 0;
  for (const TagSpan& tag : scan_tags(text).tags)
    for (const AttributeSpan& span : tag.attributes) {
      const std::string key = std::string(tag.name) + "." + std::string(span.name);
      if (!attributes.count(key)) continue;
      out.append(text, copied, span.value_begin - copied).append("_");
      copied = span.value_end;
    }
  return out.append(text, copied, std::string::npos);
}

TEST(RewriteRobot, InitialDesignGivesTheSameBytes) {
  for (const char* name :
       {"puppy", "crooked", "piston_puppy", "crooked_piston", "crooked_printed"}) {
    const std::string xml = test::named_robot(name);
    const RobotModel robot = parse_robot(xml, "robot.xml");
    EXPECT_TRUE(rewrite_robot(robot, robot.space.initial()) == xml);
  }
}

TEST(RewriteRobot, ThereAndBackGivesTheSameRobot) {
  const RobotModel robot = read_robot(test::puppy_file());
  std::mt19937 random(5);
  const VectorXd s = test::random_design(robot.space, random), s0 = robot.space.initial();
  const RobotModel there = parse_robot(rewrite_robot(robot, s), "there.xml");
  const RobotModel back = parse_robot(rewrite_robot(there, s0), "back.xml");
  EXPECT_EQ(find_difference(robot.morphology, s0, back.morphology, s0), "");
  EXPECT_EQ(find_difference(robot.morphology, s0, there.morphology, s0), "");  // as functions of s
  EXPECT_NE(find_difference(robot.morphology, s0, there.morphology, s), "");   // negative control
}

class RandomDesigns : public testing::TestWithParam<const char*> {};

TEST_P(RandomDesigns, CompileAndMatchMujoco) {
  const std::string xml = test::named_robot(GetParam());
  const RobotModel robot = parse_robot(xml, GetParam());
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int trial = 0; trial < 100; ++trial) {
    const VectorXd s = test::random_design(robot.space, random);
    const test::MujocoRobot engine(rewrite_robot(robot, s));
    VectorXd qpos(engine.nq()), qvel(engine.nv());
    for (double& x : qpos) x = uniform(random);
    for (double& x : qvel) x = uniform(random);
    qpos.segment<4>(3).normalize();
    const test::RobotState reference = engine.state(robot.morphology, qpos, qvel);
    ASSERT_LT(test::difference(reference, test::state_of(robot.morphology, s, qpos, qvel)), 1e-9)
        << "trial " << trial;
    ASSERT_GT(test::difference(reference,
                               test::state_of(robot.morphology, robot.space.initial(), qpos, qvel)),
              1e-4);
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, RandomDesigns,
                         testing::Values("puppy", "crooked", "piston_puppy", "crooked_piston",
                                         "crooked_printed"));

TEST(RewriteRobot, TouchesBoundAttributesOnly) {
  const RobotModel robot = read_robot(test::puppy_file());
  const std::set<std::string> bound = {
      "numeric.data", "joint.axis",  "inertial.pos", "inertial.diaginertia",
      "geom.pos",     "geom.fromto", "geom.size",    "body.pos",
      "key.qpos",     "key.ctrl"};
  const VectorXd s = 0.5 * (robot.space.lower() + robot.space.upper()) + 0.1 * robot.space.scale();
  const std::string text = rewrite_robot(robot, robot.space.clamp(s));
  EXPECT_NE(text, robot.xml);
  EXPECT_EQ(blanked(text, bound), blanked(robot.xml, bound));
  EXPECT_NE(blanked(text, {}), blanked(robot.xml, {}));  // negative control
}

TEST(RewriteRobot, OneAxisTouchesItsTwoJointsAndItsValue) {
  const RobotModel robot = read_robot(test::puppy_file());
  VectorXd s = robot.space.initial();
  s[6] = 0.25;
  std::string expected = robot.xml;
  const std::string x = "0.247403959255", y = "0.968912421711";
  expected = test::with(expected, "\"FL_hip\" axis=\"0 1 0\"",
                        "\"FL_hip\" axis=\"-" + x + " " + y + " 0\"");
  expected = test::with(expected, "\"FR_hip\" axis=\"0 1 0\"",
                        "\"FR_hip\" axis=\"" + x + " " + y + " 0\"");
  expected = test::with(expected, "front_hip_axis_yaw\" data=\"0 -1.4",
                        "front_hip_axis_yaw\" data=\"0.25 -1.4");
  // The keyframe is another matter (keyframes_test).
  const std::set<std::string> key = {"key.qpos", "key.ctrl"};
  EXPECT_EQ(blanked(rewrite_robot(robot, s), key), blanked(expected, key));
}

TEST(RewriteRobot, AddsWhatWasInheritedAndFillsTheInertia) {
  const RobotModel robot = parse_robot(test::crooked_robot(), "crooked");
  VectorXd s = robot.space.initial();
  s[0] = 0.25;
  s[2] = 0.25;
  const std::string text = rewrite_robot(robot, s);
  const std::size_t lamp = text.find("<site name=\"lamp\" class=\"lamp\" pos=\"");
  EXPECT_NE(lamp, std::string::npos);
  const std::size_t trunk =
      text.find("<inertial pos=\"0.0125 0.02 -0.01\" mass=\"2\" fullinertia=");
  EXPECT_NE(trunk, std::string::npos) << text.substr(0, 900);
  // The trunk's box is drawn turned by 90 degrees: its second side lies along x.
  EXPECT_NE(text.find("size=\"0.1 0.1 0.02\" euler=\"0 0 90\""), std::string::npos)
      << text.substr(0, 900);
}

TEST(RewriteRobot, RefusesDesignsOutsideOfTheBounds) {
  const RobotModel robot = read_robot(test::puppy_file());
  VectorXd s = robot.space.initial();
  EXPECT_THROW(rewrite_robot(robot, s.head(3)), std::invalid_argument);
  s[0] = 1.0;
  EXPECT_THROW(rewrite_robot(robot, s), std::invalid_argument);
  s[0] = std::nan("");
  EXPECT_THROW(rewrite_robot(robot, s), std::invalid_argument);
  EXPECT_NO_THROW(rewrite_robot(robot, robot.space.upper()));
  EXPECT_NO_THROW(rewrite_robot(robot, robot.space.lower()));
}

TEST(RewriteRobot, NoticesWhenTheResultIsNotTheIntendedOne) {
  RobotModel robot = read_robot(test::puppy_file());
  VectorXd s = robot.space.initial();
  s[0] = 0.07;
  robot.morphology.feet[0].position.constant.x() += 1e-6;  // as if the planner's robot were another
  EXPECT_THROW(rewrite_robot(robot, s), std::logic_error);
}

}  // namespace
}  // namespace legwright
