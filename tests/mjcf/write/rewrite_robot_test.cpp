// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/rewrite_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mjcf/text/numbers.hpp"
#include "mjcf/text/text_scan.hpp"
#include "mjcf/write/verify.hpp"
#include "tests/mjcf/robots/point_mass_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

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
  for (const char* name : {"puppy", "crooked", "piston_puppy", "crooked_piston", "crooked_printed",
                           "crooked_weighed"}) {
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

TEST(RewriteRobot, ABodyToBeLookedAtDiffersInItsKeyframesAlone) {
  for (const char* name : {"puppy", "crooked", "piston_puppy", "crooked_piston", "crooked_printed",
                           "crooked_weighed"}) {
    const RobotModel robot = parse_robot(test::named_robot(name), "robot.xml");
    std::mt19937 random(7);
    const VectorXd s = test::random_design(robot.space, random);
    const std::set<std::string> key{"key.qpos", "key.ctrl"};
    EXPECT_EQ(blanked(rewrite_body(robot, s), key), blanked(rewrite_robot(robot, s), key));
    EXPECT_TRUE(rewrite_body(robot, robot.space.initial()) == robot.xml);
    EXPECT_THROW(rewrite_body(robot, s.head(3)), std::invalid_argument);
  }
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
                                         "crooked_printed", "crooked_weighed", "shifted_puppy",
                                         "shifted_crooked"));

TEST(RewriteRobot, HingesOffTheOriginsOfTheirBodiesAreNoMatter) {
  for (const char* name : {"puppy", "crooked", "crooked_printed", "crooked_weighed"}) {
    const RobotModel robot = parse_robot(test::named_robot(name), name);
    const RobotModel shifted = parse_robot(test::named_robot(std::string("shifted_") + name), name);
    std::mt19937 random(3);
    for (int trial = 0; trial < 5; ++trial) {
      const VectorXd s = test::random_design(robot.space, random);
      // MuJoCo writes six digits.
      EXPECT_EQ(find_difference(robot.morphology, s, shifted.morphology, s, 2e-5), "") << name;
    }
  }
}

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

/// Digits of a number from the first that is not zero.
std::size_t digits_of(std::string_view number) {
  std::string digits;
  for (const char c : number.substr(0, number.find('e')))
    if (c >= '0' && c <= '9' && (c != '0' || !digits.empty())) digits += c;
  return digits.size();
}

/// Most digits of a number that a design changed.
std::size_t longest_new_number(const std::string& before, const std::string& after) {
  const TagScan old = scan_tags(before), now = scan_tags(after);
  std::size_t longest = 0;
  for (std::size_t k = 0; k < now.tags.size(); ++k)
    for (const AttributeSpan& span : now.tags[k].attributes) {
      const std::string value = after.substr(span.value_begin, span.value_end - span.value_begin);
      bool is_old = false;
      for (const AttributeSpan& other : old.tags[k].attributes)
        is_old = is_old ||
                 (other.name == span.name &&
                  before.substr(other.value_begin, other.value_end - other.value_begin) == value);
      if (is_old) continue;
      for (const std::string_view word : split_words(value))
        longest = std::max(longest, digits_of(word));
    }
  return longest;
}

TEST(RewriteRobot, WritesTwelveDigitsAndTheDesignThatTheyMean) {
  for (const char* name : {"puppy", "crooked", "piston_puppy", "crooked_piston", "crooked_printed",
                           "crooked_weighed"}) {
    const RobotModel robot = parse_robot(test::named_robot(name), "robot.xml");
    std::mt19937 random(9);
    const VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);
    const std::size_t longest = longest_new_number(robot.xml, text);
    EXPECT_EQ(longest, 12u) << name;  // there are numbers that were rounded
    const RobotModel written = parse_robot(text, "robot.xml", &robot.structure);
    const VectorXd s_written = written.space.initial();
    EXPECT_TRUE(s_written.isApprox(s, 1e-11));
    EXPECT_NE(s_written, s);
    for (const double value : s_written) EXPECT_EQ(value, rounded(value));
    // Geometry and declared values agree, and what they say gives the same file.
    EXPECT_EQ(find_difference(robot.morphology, s_written, written.morphology, s_written), "")
        << name;
    EXPECT_TRUE(rewrite_robot(robot, s_written) == text);
    EXPECT_TRUE(rewrite_robot(written, s_written) == text);
  }
}

/// A bound of more digits: rounded up, the design would lie outside.
TEST(RewriteRobot, ABoundOfManyDigitsIsNotPassed) {
  for (const double bound : {0.0933333333333333, 0.0966666666666667}) {
    const std::string xml = test::with(test::read_file(test::puppy_file()), "0.06 0.036 0.096",
                                       "0.06 0.036 " + format_number(bound));
    const RobotModel robot = parse_robot(xml, "robot.xml");
    const std::string text = rewrite_robot(robot, robot.space.upper());
    const double value = parse_robot(text, "robot.xml").space.initial()[0];
    EXPECT_EQ(value, std::min(rounded(bound), bound));
    EXPECT_NEAR(value, bound, 1e-12);
  }
  EXPECT_GT(rounded(0.0966666666666667), 0.0966666666666667);  // else this shows nothing
}

/// A design that differs by nothing but rounding is the initial one.
TEST(RewriteRobot, ADesignWithinRoundingOfTheInitialIsTheFile) {
  const RobotModel robot = read_robot(test::puppy_file());
  VectorXd s = robot.space.initial();
  s[0] *= 1 + 1e-14;
  EXPECT_TRUE(rewrite_robot(robot, s) == robot.xml);
  s[0] *= 1 + 1e-10;
  EXPECT_FALSE(rewrite_robot(robot, s) == robot.xml);
}

/// The moments of a plate: the largest is the sum of the others, also after rounding.
TEST(RewriteRobot, APlateStaysABody) {
  std::string xml = test::read_file(test::puppy_file());
  const std::string thigh = "<joint name=\"FL_hip\" axis=\"0 1 0\"/>";
  const std::size_t at = xml.find("diaginertia=\"", xml.find(thigh)) + 13;
  xml.replace(at, xml.find('"', at + 1) + 1 - at, "2.1e-5 2.4e-5 3e-6\"");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial)
    EXPECT_NO_THROW(rewrite_robot(robot, test::random_design(robot.space, random)));
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
