// SPDX-License-Identifier: Apache-2.0
// Hulls that follow the design: read, weighed, rewritten, refused.
#include "mjcf/read/connectors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/write/connector_hulls.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "mjcf/write/verify.hpp"
#include "optimizer/design/growth.hpp"
#include "optimizer/design/inertia.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using test::error_message;
using test::holds;

const std::vector<Vector3d> kNear{{0.006, 0.004, 0.005},  {-0.006, 0.004, 0.006},
                                  {0.005, 0.008, -0.006}, {-0.006, 0.007, -0.007},
                                  {0.0, 0.004, -0.001},   {0.0092, 0.005, -0.03}};
const std::vector<Vector3d> kFar{{0.009, -0.006, 0.012},
                                 {-0.008, -0.007, 0.013},
                                 {0.007, 0.009, 0.015},
                                 {-0.007, 0.008, 0.014},
                                 {0.0, 0.001, 0.009}};

std::string words(const std::vector<Vector3d>& points) {
  std::string out;
  for (const Vector3d& point : points) out += " " + format_numbers(point);
  return out;
}

/// The shanks' knee and foot, and thighs with a hull between hip and knee, of two legs.
std::string leg(const std::string& side, double y) {
  std::vector<Vector3d> all = kNear;
  for (const Vector3d& point : kFar) all.push_back(Vector3d(0.004, 0.0, -0.1) + point);
  const std::vector<Facet> facets = convex_hull(all);
  const SolidInertial own = inertial_of(moments_of_solid(facets, all), 1240.0);
  return fmt::format(R"(
      <body name="{0}_thigh" pos="0.02 {1} -0.02">
        <joint name="{0}_hip" axis="0 1 0" range="-2 2"/>
        <geom type="capsule" size="0.006" fromto="0 0 0 0.004 0 -0.1" density="0"/>
        <body name="{0}_arm">
          <inertial pos="{2}" mass="{3}" fullinertia="{4}"/>
          <geom type="mesh" mesh="{0}_arm" contype="0" conaffinity="0"/>
        </body>
        <body name="{0}_servo" pos="0.004 0 -0.1">
          <inertial pos="0 0 0.01" mass="0.05" diaginertia="1e-5 1e-5 1e-5"/>
        </body>
        <body name="{0}_shank" pos="0.004 0 -0.1">
          <joint name="{0}_knee" axis="0 1 0" range="-2 2"/>
          <geom type="capsule" size="0.005" fromto="0 0 0 0 0 -0.09" density="1000"/>
          <geom name="{0}_foot" size="0.012" pos="0 0 -0.1" mass="0.01"/>
        </body>
      </body>)",
                     side, y, format_numbers(rounded(VectorXd(own.centre))),
                     format_number(rounded(own.mass)), format_numbers(rounded(VectorXd(own.full))));
}

std::string robot_text() {
  std::vector<Vector3d> all = kNear;
  for (const Vector3d& point : kFar) all.push_back(Vector3d(0.004, 0.0, -0.1) + point);
  const VectorXd corners = vertices_of(convex_hull(all), all);
  const std::string vertices = format_numbers(rounded(corners));
  std::string custom, motors;
  for (const char* side : {"L", "R"}) {
    custom += fmt::format(
        "    <text name=\"legwright_connector/{0}_arm\" data=\"1240 kg/m3 | body {0}_arm:{1} | "
        "body {0}_servo:{2}\"/>\n",
        side, words(kNear), words(kFar));
    for (const char* joint : {"hip", "knee"})
      motors += fmt::format("    <motor joint=\"{}_{}\" forcerange=\"-3 3\"/>\n", side, joint);
  }
  return fmt::format(R"(<mujoco model="c"><compiler angle="radian" autolimits="true"/>
  <asset><mesh name="L_arm" vertex="{0}"/><mesh name="R_arm" vertex="{0}"/></asset>
  <worldbody><body name="trunk" pos="0 0 0.24"><freejoint/>
      <inertial pos="0 0 0" mass="0.5" diaginertia="1e-3 1e-3 1e-3"/>{1}{2}
  </body></worldbody>
  <actuator>
{3}  </actuator>
  <custom>
    <numeric name="legwright/thigh" data="{4} 0.07 0.16"/>
    <text name="legwright/thigh" data="m | stretch link: L_thigh R_thigh | Length of thighs."/>
{5}  </custom>
</mujoco>
)",
                     vertices, leg("L", 0.05), leg("R", -0.05), motors,
                     format_number(Vector3d(0.004, 0.0, -0.1).norm()), custom);
}

/// The robot with another hull between two things that go the same way, the servo of each knee and
/// a body where that is, and with a parameter that turns the knees' axes, and their servos.
std::string with_brackets() {
  std::vector<Vector3d> all = kNear;
  all.insert(all.end(), kFar.begin(), kFar.end());
  const std::vector<Facet> facets = convex_hull(all);
  const SolidInertial own = inertial_of(moments_of_solid(facets, all), 1240.0);
  const VectorXd corners = vertices_of(facets, all);
  std::string text = robot_text();
  const auto insert = [&text](const std::string& before, const std::string& what) {
    text.insert(text.find(before), what);
  };
  for (const std::string side : {"L", "R"}) {
    insert("</asset>", fmt::format("<mesh name=\"{}_bracket\" vertex=\"{}\"/>", side,
                                   format_numbers(rounded(corners))));
    insert(
        fmt::format("<body name=\"{}_shank\"", side),
        fmt::format(R"(<body name="{0}_bracket" pos="0.004 0 -0.1">
             <inertial pos="{1}" mass="{2}" fullinertia="{3}"/>
             <geom type="mesh" mesh="{0}_bracket" contype="0" conaffinity="0"/></body>)",
                    side, format_numbers(rounded(VectorXd(own.centre))),
                    format_number(rounded(own.mass)), format_numbers(rounded(VectorXd(own.full)))));
    insert("</custom>",
           fmt::format("<text name=\"legwright_connector/{0}_bracket\" data=\"1240 kg/m3 | body "
                       "{0}_bracket:{1} | body {0}_servo:{2}\"/>"
                       "<text name=\"legwright_turns/{0}_servo\" data=\"joint {0}_knee\"/>",
                       side, words(kNear), words(kFar)));
  }
  insert("</custom>",
         "<numeric name=\"legwright/knee\" data=\"0 -1 1\"/><text name=\"legwright/knee\" "
         "data=\"rad | axis z: L_knee ~R_knee | Turn of the axes of knees.\"/>");
  return text;
}

/// Seen from their link such hulls move with a length, which in their own body they do not.
TEST(Connectors, WhoseEndsGoTheSameWayAreMadeAnewWhereOneTurns) {
  const RobotModel robot = parse_robot(with_brackets(), "c.xml");
  ASSERT_EQ(robot.connectors.size(), 4u);
  VectorXd s = robot.space.initial();
  s[robot.space.find("thigh")] = 0.12;
  s[robot.space.find("knee")] = 0.5;
  const RobotModel written = parse_robot(rewrite_robot(robot, s), "c.xml");
  EXPECT_EQ(find_difference(with_hulls_at(robot, s), s, written.morphology, s, 1e-10), "");
}

VectorXd at_length(double length) { return VectorXd::Constant(1, length); }

TEST(Connectors, AreReadWithTheirPoints) {
  const RobotModel robot = parse_robot(robot_text(), "c.xml");
  ASSERT_EQ(robot.connectors.size(), 2u);
  const Connector& arm = robot.connectors[1];
  EXPECT_EQ(arm.mesh, "R_arm");
  EXPECT_EQ(arm.density, 1240.0);
  ASSERT_EQ(arm.points.size(), kNear.size() + kFar.size());
  // Far points go with the knee, near ones stay.
  const Vector3d way = Vector3d(0.004, 0.0, -0.1).normalized();
  for (std::size_t k = 0; k < arm.points.size(); ++k) {
    const Vector3d moved =
        arm.points[k].at(at_length(0.12)) - arm.points[k].at(robot.space.initial());
    const double far = k < kNear.size() ? 0.0 : 0.12 - robot.space.parameters[0].initial;
    EXPECT_NEAR((moved - far * way).norm(), 0.0, 1e-15);
  }
}

TEST(Connectors, WeighInFAsInMujoco) {
  const RobotModel robot = parse_robot(robot_text(), "c.xml");
  const ModelPointer model = compile_mjcf(robot_text(), "c.xml");
  EXPECT_NEAR(robot.morphology.total_mass(), model->body_subtreemass[0], 1e-12);
  EXPECT_TRUE(robot.morphology.grows());
  const GrowthSum printed =
      growth_sum(robot.morphology, Amount::printed_volume, robot.space.initial());
  EXPECT_NEAR(printed.value * 1240.0,
              2.0 * model->body_mass[mj_name2id(model.get(), mjOBJ_BODY, "L_arm")], 1e-12);
}

/// Written at another length, the file is the robot that F and the hull made anew take it to be:
/// rewrite_robot() compares them, and refuses what differs. Here with what MuJoCo weighs.
TEST(Connectors, AreMadeAnewWhereALengthChanges) {
  const RobotModel robot = parse_robot(robot_text(), "c.xml");
  for (const double length : {0.075, 0.09, 0.101, 0.13, 0.16}) {
    const VectorXd s = at_length(length);
    const std::string text = rewrite_robot(robot, s);
    const RobotModel written = parse_robot(text, "c.xml");
    EXPECT_EQ(find_difference(with_hulls_at(robot, s), s, written.morphology, s, 1e-10), "");
    const std::vector<Vector3d> points = points_at(robot.connectors[0].points, s);
    const double volume = moments_of_solid(convex_hull(points), points).volume;
    const ModelPointer model = compile_mjcf(text, "c.xml");
    EXPECT_NEAR(model->body_mass[mj_name2id(model.get(), mjOBJ_BODY, "L_arm")], 1240.0 * volume,
                1e-11 * 1240.0 * volume);
    EXPECT_NEAR(GeometryAtDesign(with_hulls_at(robot, s), s).total_mass, model->body_subtreemass[0],
                1e-11);
  }
  EXPECT_EQ(rewrite_robot(robot, robot.space.initial()), robot.xml);
}

/// First and second derivatives of a link's moments against differences, while triangles stay.
TEST(Connectors, MomentsHaveTheirDerivatives) {
  const RobotModel robot = parse_robot(robot_text(), "c.xml");
  const double at = 0.103, step = 1e-5;
  const auto of = [&](double length) {
    return GeometryAtDesign(robot.morphology, at_length(length)).links[1];
  };
  const LinkAtDesign here = of(at), before = of(at - step), after = of(at + step);
  ASSERT_EQ(here.inner.size(), 1u);
  const Eigen::Matrix4d first = here.inner[0].moments + here.inner[0].moments.transpose();
  const Eigen::Matrix4d second = here.inner[0].products[0] + here.inner[0].products[0].transpose() +
                                 here.inner[0].seconds[0] + here.inner[0].seconds[0].transpose();
  const Eigen::Matrix4d by_difference = (after.moments - before.moments) / (2.0 * step);
  const Eigen::Matrix4d twice =
      (after.moments - 2.0 * here.moments + before.moments) / (step * step);
  EXPECT_NEAR((first - by_difference).norm(), 0.0, 1e-8 * first.norm());
  EXPECT_NEAR((second - twice).norm(), 0.0, 1e-4 * second.norm());
  // And they are those of the hull itself.
  EXPECT_EQ(facets_at(robot.connectors[0], points_at(robot.connectors[0].points, at_length(at))),
            robot.connectors[0].facets);
}

/// Where triangles change on the way, F's polynomial is off by little, and the file is the hull.
TEST(Connectors, ChangedTrianglesCostLittle) {
  const RobotModel robot = parse_robot(robot_text(), "c.xml");
  int changed = 0;
  for (const double length : {0.07, 0.08, 0.09, 0.11, 0.13, 0.16}) {
    const VectorXd s = at_length(length);
    const std::vector<Vector3d> points = points_at(robot.connectors[0].points, s);
    changed += facets_at(robot.connectors[0], points) != robot.connectors[0].facets;
    const double hull = moments_of_solid(convex_hull(points), points).volume;
    const double taken = growth_sum(robot.morphology, Amount::printed_volume, s).value / 2.0;
    EXPECT_NEAR(taken, hull, 0.02 * hull) << length;
  }
  EXPECT_GT(changed, 0);
}

TEST(Connectors, WhatDoesNotFitIsRefused) {
  const std::string good = robot_text();
  EXPECT_EQ(error_message(good), "");
  const auto refused = [&](const char* part, const char* by, const char* words_of_it) {
    const std::string told = error_message(test::with(good, part, by));
    EXPECT_TRUE(holds(told, words_of_it)) << told;
  };
  refused("1240 kg/m3", "1240", "is no density");
  refused("1240 kg/m3", "1000 kg/m3", "whose hull weighs");
  refused("connector/L_arm", "connector/l_arm", "of which there is no <mesh>");
  refused("body L_servo:", "bodi L_servo:", "is no end with points");
  refused("body L_servo:", "body R_servo:", "does not stand in the body that holds 'L_arm'");
  refused("body L_servo: 0.009", "body L_servo: 0.019", "is no longer the hull of the points");
  refused("body L_servo: 0.009", "body L_servo: x", "is no end with points");
  refused("<mesh name=\"L_arm\"", "<mesh name=\"L_arm\" scale=\"1 1 2\"", "remove scale");
  refused("mesh=\"L_arm\" contype", "mesh=\"R_arm\" contype", "no geom shows");
  refused("mesh=\"L_arm\" contype", "pos=\"0 0 1\" mesh=\"L_arm\" contype", "put it into one");
}

}  // namespace
}  // namespace legwright
