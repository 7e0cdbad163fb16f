// SPDX-License-Identifier: Apache-2.0
// Masses from density times geometry: their sums against MuJoCo's are in read_robot_test and
// rewrite_robot_test.
#include "mjcf/read/printed.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/growth.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using test::error_message;

TEST(Printed, MassAndVolumeGrowWithTheStretch) {
  const std::string xml = test::with(
      test::named_robot("puppy"),
      "<inertial pos=\"0 0 -0.05307692308\" mass=\"0.104\" diaginertia=\"2.481538462e-05 "
      "2.481538462e-05 2e-06\"/>\n        <geom class=\"rod\" fromto=\"0 0 0 0 0 -0.06\"/>",
      "<geom class=\"rod\" density=\"1200\" fromto=\"0 0 0 0 0 -0.06\"/>");
  const RobotModel robot = parse_robot(xml, "p");
  Eigen::VectorXd s = robot.space.initial();
  const auto mass = [&] { return growth_sum(robot.morphology, Amount::mass, s).value; };
  const auto volume = [&] { return growth_sum(robot.morphology, Amount::printed_volume, s).value; };
  const double before = mass(), round = 4.0 / 3 * std::numbers::pi * 0.008 * 0.008 * 0.008;
  EXPECT_TRUE(robot.morphology.grows());
  EXPECT_NEAR(volume(), std::numbers::pi * 0.008 * 0.008 * 0.06 + round, 1e-15);
  s[0] = 0.09;  // the round ends stay as they are
  EXPECT_NEAR(volume(), std::numbers::pi * 0.008 * 0.008 * 0.09 + round, 1e-15);
  EXPECT_NEAR(mass() - before, 1200 * std::numbers::pi * 0.008 * 0.008 * 0.03, 1e-12);
  EXPECT_FALSE(parse_robot(test::named_robot("puppy"), "p").morphology.grows());
}

/// What the file tells by `mass` grows as what it tells by `density`, and is told by `mass` again.
TEST(Printed, ACapsuleWithAMassOfItsOwnKeepsItsDensity) {
  const std::string inertial =
      "<inertial pos=\"0 0 -0.05307692308\" mass=\"0.104\" diaginertia=\"2.481538462e-05 "
      "2.481538462e-05 2e-06\"/>\n        <geom class=\"rod\" fromto=\"0 0 0 0 0 -0.06\"/>";
  const auto with_rod = [&](const std::string& weight) {
    return parse_robot(
        test::with(test::named_robot("puppy"), inertial,
                   "<geom class=\"rod\" " + weight + " fromto=\"0 0 0 0 0 -0.06\"/>"),
        "p");
  };
  const RobotModel weighed = with_rod("mass=\"0.02\"");
  const double volume = std::numbers::pi * 0.008 * 0.008 * (0.06 + 4.0 / 3 * 0.008);
  const RobotModel printed = with_rod(fmt::format("density=\"{}\"", 0.02 / volume));
  Eigen::VectorXd s = weighed.space.initial();
  s[0] = 0.09;
  for (const Amount amount : {Amount::mass, Amount::printed_volume})
    EXPECT_NEAR(growth_sum(weighed.morphology, amount, s).value,
                growth_sum(printed.morphology, amount, s).value, 1e-12);
  const double grown = 0.02 * (0.09 + 4.0 / 3 * 0.008) / (0.06 + 4.0 / 3 * 0.008);
  const std::string text = rewrite_robot(weighed, s);
  EXPECT_TRUE(test::holds(text, fmt::format("mass=\"{:.6f}", grown).substr(0, 13))) << text;
  EXPECT_FALSE(test::holds(text, "mass=\"0.02\""));
}

TEST(Printed, APartWithAMassOfItsOwnWeighsButIsNotPrinted) {
  const std::string inertial =
      "<inertial pos=\"0 0 -0.05307692308\" mass=\"0.104\" diaginertia=\"2.481538462e-05 "
      "2.481538462e-05 2e-06\"/>\n        <geom class=\"rod\" fromto=\"0 0 0 0 0 -0.06\"/>";
  const std::string rod = "<geom class=\"rod\" density=\"1200\" fromto=\"0 0 0 0 0 -0.06\"/>";
  const auto with_servo = [&](const std::string& weight) {
    return parse_robot(test::with(test::named_robot("puppy"), inertial,
                                  rod + "<geom type=\"sphere\" size=\"0.01\" " + weight +
                                      " contype=\"0\" "
                                      "conaffinity=\"0\"/>"),
                       "p");
  };
  const double ball = 4.0 / 3 * std::numbers::pi * 1e-6;
  const auto sum = [](const RobotModel& robot, Amount amount) {
    return growth_sum(robot.morphology, amount, robot.space.initial()).value;
  };
  const RobotModel weighed = with_servo("mass=\"0.05\""), printed = with_servo("density=\"1200\"");
  EXPECT_NEAR(sum(printed, Amount::printed_volume) - sum(weighed, Amount::printed_volume), ball,
              1e-15);
  EXPECT_NEAR(weighed.morphology.total_mass() - printed.morphology.total_mass(), 0.05 - 1200 * ball,
              1e-9);
}

TEST(Printed, WhatDoesNotKeepItsShapeIsRefused) {
  const std::string good = test::named_robot("crooked_printed");
  EXPECT_EQ(error_message(good), "");
  EXPECT_NE(error_message(test::with(good, "fromto=\"0.02 -0.06 0.01 0.02 0.04 0.01\"",
                                     "fromto=\"0.02 -0.06 0.01 0.03 0.04 0.01\""))
                .find("in body 'trunk' weighs density times geometry"),
            std::string::npos);
  EXPECT_NE(error_message(
                test::with(good, "autolimits=\"true\"", "autolimits=\"true\" settotalmass=\"3\""))
                .find("weigh"),
            std::string::npos);
  EXPECT_NE(error_message(test::with(good, "size=\"0.012\" density=\"700\"",
                                     "size=\"0.012\" density=\"700\" shellinertia=\"true\""))
                .find("weigh"),
            std::string::npos);
}

/// A mesh that gives its body a weight keeps its size: its sole goes where a stretch takes it only
/// across that.
TEST(PrintedFeet, AMeshWithAWeightIsRefusedUnlessItsSoleIsAcrossTheStretch) {
  const auto robot = [](double deep, const std::string& inertial) {
    std::string xml = test::with(
        test::hopper_with(fmt::format(
            "<geom name=\"tip\" type=\"mesh\" mesh=\"shoe\" pos=\"0 0 {}\"/>", -0.2 + deep)),
        "</actuator>",
        "</actuator><custom><numeric name=\"legwright/shank\" data=\"0.2 0.1 0.3\"/>"
        "<text name=\"legwright/shank\" data=\"m | stretch z: shank | l\"/></custom>");
    xml = test::with(xml, "<mesh name=\"shoe\"",
                     fmt::format("<mesh name=\"shoe\" refpos=\"0 0 {}\"", deep));
    const std::string own =
        "<inertial pos=\"0 0 -0.1\" mass=\"0.1\" diaginertia=\"1e-4 1e-4 1e-5\"/>";
    const std::size_t shank = xml.rfind(own);
    return xml.replace(shank, own.size(), inertial);
  };
  // refpos: vertices are told from there, so the sole is as far below the origin as that is above
  // it.
  const std::string refused = error_message(robot(0.03, ""));
  EXPECT_TRUE(test::holds(refused, "gives its body, which has no <inertial>, a weight")) << refused;
  EXPECT_TRUE(test::holds(refused, "-0.03 m along the stretch")) << refused;
  EXPECT_EQ(error_message(robot(
                0.03, "<inertial pos=\"0 0 -0.1\" mass=\"0.1\" diaginertia=\"1e-4 1e-4 1e-5\"/>")),
            "");
  const RobotModel taken = parse_robot(robot(0.0, ""), "robot.xml");
  Eigen::VectorXd s = taken.space.initial();
  s[0] *= 1.2;
  EXPECT_NO_THROW(
      rewrite_robot(taken, s));  // which compares the written robot with the planned one
}

}  // namespace
}  // namespace legwright
