// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/point_mass_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;
using test::error_message;
using test::holds;

std::string calf(const std::string& parts) {
  return test::with(
      test::hopper_with(parts + "<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>"),
      "<keyframe>",
      "<custom><numeric name=\"legwright/long\" data=\"0.2 0.1 0.4\"/>"
      "<text name=\"legwright/long\" data=\"m | stretch link: shank | l\"/>"
      "</custom><keyframe>");
}

std::string stretched(const std::string& xml, double length) {
  return rewrite_robot(parse_robot(xml, "robot.xml"), VectorXd::Constant(1, length));
}

TEST(Stretched, FramesMoveAndTheirPartsWithThem) {
  const std::string text = stretched(
      calf("<frame name=\"f\" pos=\"0.01 0 -0.1\" euler=\"0 1.5707963267948966 0\">"
           "<geom type=\"box\" pos=\"0.05 0 0.02\" size=\"0.03 0.01 0.02\" contype=\"0\" "
           "conaffinity=\"0\"/>"
           "<frame pos=\"0.01 0 0\"><camera name=\"c\" pos=\"0.03 0 0\"/></frame></frame>"),
      0.4);
  // The frame's x is the body's −z: what lies along it grows, its z stays.
  EXPECT_TRUE(holds(text, "<frame name=\"f\" pos=\"0.01 0 -0.2\"")) << text;
  const ModelPointer model = compile_mjcf(text, "x");
  EXPECT_NEAR(model->geom_pos[0], 0.01 + 0.02, 1e-12);
  EXPECT_NEAR(model->geom_pos[2], 2 * (-0.1 - 0.05), 1e-12);
  EXPECT_NEAR(model->geom_size[0], 0.06, 1e-12);
  EXPECT_EQ(model->geom_size[2], 0.02);
  EXPECT_NEAR(model->cam_pos[2], 2 * (-0.1 - 0.04), 1e-12);
}

TEST(Stretched, MeshesScaleInTheirAssets) {
  const std::string mesh =
      "<geom type=\"mesh\" mesh=\"shoe\" mass=\"0\" contype=\"0\" conaffinity=\"0\" pos=\"0 0 "
      "-0.1\"/>";
  EXPECT_TRUE(holds(stretched(calf(mesh), 0.4), "<mesh name=\"shoe\" vertex="));
  const auto scale = [](const std::string& text) {
    const std::size_t at = text.find(" scale=\"");
    return at == std::string::npos ? "" : text.substr(at + 8, text.find('"', at + 8) - at - 8);
  };
  EXPECT_EQ(scale(stretched(calf(mesh), 0.4)), "1 1 2");
  EXPECT_EQ(scale(stretched(test::with(calf(mesh), "<mesh name=\"shoe\"",
                                       "<mesh name=\"shoe\" scale=\"0.5 1 0.25\""),
                            0.4)),
            "0.5 1 0.5");
  EXPECT_EQ(scale(stretched(calf(mesh + mesh), 0.4)), "1 1 2");
  const std::string rotated = test::with(mesh, "pos=", "euler=\"0 1.5707963267948966 0\" pos=");
  EXPECT_EQ(scale(stretched(calf(rotated), 0.4)), "2 1 1");
  // They disagree: another asset for the second.
  const std::string two = stretched(calf(mesh + rotated), 0.4);
  EXPECT_TRUE(holds(two, "<mesh name=\"shoe_2\" vertex=")) << two;
  EXPECT_EQ(scale(two), "1 1 2");
  EXPECT_TRUE(holds(two, "scale=\"2 1 1\"/>"));
  // The trunk shows it too, and keeps the element.
  const std::string both = stretched(
      test::with(calf(mesh), "<body name=\"thigh\">", mesh + "<body name=\"thigh\">"), 0.4);
  EXPECT_TRUE(holds(both, "-0.01 0 0.06  0.01 0 0.06\"/>\n    <mesh name=\"shoe_2\"")) << both;
  EXPECT_EQ(scale(both), "1 1 2");
  // What collides grows as boxes do.
  EXPECT_EQ(scale(stretched(calf("<geom type=\"mesh\" mesh=\"shoe\" pos=\"0 0 -0.1\"/>"), 0.4)),
            "1 1 2");
}

TEST(Stretched, RodsPlacedByPosGrowWhereTheyMakeUpTheLink) {
  const auto size = [](const std::string& rod) {
    const ModelPointer model = compile_mjcf(stretched(calf(rod), 0.4), "x");
    return model->geom_size[1];
  };
  EXPECT_EQ(size("<geom type=\"cylinder\" size=\"0.01 0.09\" pos=\"0 0 -0.09\"/>"), 0.18);
  EXPECT_EQ(size("<geom type=\"capsule\" size=\"0.01 0.09\" pos=\"0 0 -0.09\"/>"), 0.18);
  EXPECT_EQ(size("<geom type=\"cylinder\" size=\"0.02 0.02\" pos=\"0 0 -0.09\"/>"),
            0.02);  // a motor
  EXPECT_EQ(
      size("<geom type=\"cylinder\" size=\"0.02 0.09\" pos=\"0 0 -0.05\" euler=\"1.57 0 0\"/>"),
      0.09);
}

TEST(Stretched, APrintedBodyKeepsTheWeightOfMeshesAndOfWhatHasAMass) {
  std::string xml = calf(
      "<geom type=\"capsule\" size=\"0.01 0.09\" pos=\"0 0 -0.1\"/>"
      "<geom type=\"box\" size=\"0.01 0.02 0.03\" pos=\"0 0 -0.05\" mass=\"0.2\"/>"
      "<geom type=\"mesh\" mesh=\"shoe\" pos=\"0.01 0 -0.15\" euler=\"0.2 0.1 0\" contype=\"0\" "
      "conaffinity=\"0\"/>");
  xml = test::with(xml,
                   "<joint name=\"knee\" axis=\"0 1 0\"/>\n          <inertial pos=\"0 0 -0.1\" "
                   "mass=\"0.1\" diaginertia=\"1e-4 1e-4 1e-5\"/>",
                   "<joint name=\"knee\" axis=\"0 1 0\"/>");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  const double before = compile_mjcf(xml, "x")->body_mass[3];
  for (const double length : {0.1, 0.15, 0.3, 0.4}) {
    const double after = compile_mjcf(stretched(xml, length), "x")->body_mass[3];
    const double grown = 1000 * std::numbers::pi * 1e-4 * 0.18 * (length / 0.2 - 1);
    EXPECT_NEAR(after - before, grown, 1e-12);
  }
  const std::string two =
      test::with(xml, "<geom type=\"capsule\"",
                 "<geom type=\"mesh\" mesh=\"shoe\" pos=\"0 0 -0.1\"/><geom type=\"capsule\"");
  EXPECT_TRUE(holds(error_message(two), "one of several meshes with a weight"));
  EXPECT_EQ(error_message(test::with(two, "pos=\"0 0 -0.1\"/><geom type=\"capsule\"",
                                     "pos=\"0.1 0 -0.15\"/><geom type=\"capsule\"")),
            "");
  EXPECT_TRUE(holds(error_message(test::with(xml, "autolimits=\"true\"",
                                             "autolimits=\"true\" settotalmass=\"3\"")),
                    "settotalmass"));
}

TEST(Angles, AreThoseOfTheFileAlsoWhereRefShiftsThem) {
  const std::string xml =
      test::with(test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>", 0.4),
                 "<joint name=\"knee\"", "<joint name=\"knee\" ref=\"0.3\"");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  const test::MujocoRobot engine(xml);
  VectorXd qpos(9), qvel(8);
  qpos << 0.1, 0.2, 0.3, 1, 0, 0, 0, 0.2, 0.7;
  qvel << 1, 2, 3, 0.1, 0.2, 0.3, -0.5, 0.8;
  const test::RobotState reference = engine.state(robot.morphology, qpos, qvel);
  EXPECT_LT(test::difference(reference, test::state_of(robot.morphology, VectorXd(), qpos, qvel)),
            1e-9);
  qpos[8] -= 0.3;  // twin
  EXPECT_GT(test::difference(reference, test::state_of(robot.morphology, VectorXd(), qpos, qvel)),
            1e-3);
  EXPECT_EQ(robot.morphology.links[2].joint.nominal, 0.4);
}

TEST(Servos, TakeGainsAndLimitsFromClassesAndJoints) {
  const RobotModel motors = parse_robot(test::classed_quadruped(), "robot.xml");
  EXPECT_EQ(motors.servos[0].torque_limit, 23.7);
  EXPECT_EQ(motors.servos[2].torque_limit, 35.55);
  EXPECT_NEAR(motors.servos[2].kp, 35.55 / 0.0375, 1e-9);
  const RobotModel servos = parse_robot(test::quadruped_with_arm(), "robot.xml");
  EXPECT_EQ(servos.servos[0].kp, 500);
  EXPECT_EQ(servos.servos[0].kd, 20);
  EXPECT_EQ(servos.servos[0].torque_limit, 45);
  EXPECT_EQ(servos.servos[2].torque_limit, 115);
}

}  // namespace
}  // namespace legwright
