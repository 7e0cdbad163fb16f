// SPDX-License-Identifier: Apache-2.0
// Actuators with states of their own, and such that drive a hinge through a tendon.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/read/servos.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kKneeServo =
    "<position name=\"knee_servo\" joint=\"knee\" kp=\"80\" kv=\"0.8\" forcerange=\"-3 3\"/>";

/// The hopper of the broken robots, mended, with another actuator at its knee and `more` before
/// all actuators.
RobotModel hopper_with(const std::string& actuator, const std::string& more = "") {
  std::string xml =
      test::with(test::read_file(test::source_path("examples/broken/robots/zero_axis.xml")),
                 "axis=\"0 0 0\"", "axis=\"0 1 0\"");
  xml = test::with(xml, kKneeServo, actuator);
  return parse_robot(test::with(xml, "<actuator>", more + "<actuator>"), "hopper.xml");
}

void expect_knee_like(const RobotModel& robot, double kp, double kd, double limit) {
  ASSERT_EQ(robot.servos.size(), 2U);
  EXPECT_NEAR(robot.servos[1].kp, kp, 1e-9);
  EXPECT_NEAR(robot.servos[1].kd, kd, 1e-9);
  EXPECT_NEAR(robot.servos[1].torque_limit, limit, 1e-9);
  EXPECT_EQ(robot.servos[1].tendon, "");
}

TEST(ActuatorDynamics, AFilterIsPlannedAsTheServoBehindItAndTold) {
  const RobotModel plain = hopper_with(kKneeServo);
  EXPECT_EQ(describe_dynamics(plain.servos), "");
  const RobotModel lagging =
      hopper_with(test::with(kKneeServo, "kv=\"0.8\"", "kv=\"0.8\" timeconst=\"0.05\""));
  expect_knee_like(lagging, 80.0, 0.8, 3.0);
  EXPECT_EQ(lagging.servos[1].lag, 0.05);
  EXPECT_EQ(describe_dynamics(lagging.servos),
            "actuators that filter their controls: knee_servo (0.05 s); gaits are planned and "
            "played on servos of the same gains and torque limits without that");
  const RobotModel motor = hopper_with(
      "<general name=\"knee_servo\" joint=\"knee\" dyntype=\"filter\" dynprm=\"0.02\" "
      "gainprm=\"3\" ctrllimited=\"true\" ctrlrange=\"-1 1\"/>");
  expect_knee_like(motor, 80.0, 1.2, 3.0);  // gains of its torque, as of any motor
  EXPECT_EQ(motor.servos[1].lag, 0.02);
}

TEST(ActuatorDynamics, AnIntegratorInFrontOfAServoIsOneAndToldToo) {
  const RobotModel robot = hopper_with(
      "<intvelocity name=\"knee_servo\" joint=\"knee\" kp=\"80\" kv=\"0.8\" actrange=\"-2 2\" "
      "forcerange=\"-3 3\"/>");
  expect_knee_like(robot, 80.0, 0.8, 3.0);
  EXPECT_EQ(
      describe_dynamics(robot.servos).find("actuators whose controls are rates: knee_servo; "), 0U);
}

constexpr const char* kAlone =
    "<tendon><fixed name=\"pull\"><joint joint=\"knee\" coef=\"-2\"/></fixed></tendon>";
constexpr const char* kPuller =
    "<position name=\"knee_servo\" tendon=\"pull\" kp=\"20\" kv=\"0.2\" forcerange=\"-1.5 1.5\"/>";

TEST(ActuatorDynamics, AFixedTendonOverOneHingeIsThatHinge) {
  const RobotModel robot = hopper_with(kPuller, kAlone);
  expect_knee_like(robot, 80.0, 0.8, 3.0);
  EXPECT_EQ(compile_mjcf(played_robot(robot, robot.xml), robot.file)->ntendon, 0);
}

TEST(ActuatorDynamics, ATendonThatDoesMoreStillCouples) {
  const std::string stiff = test::with(kAlone, "name=\"pull\"", "name=\"pull\" stiffness=\"5\"");
  EXPECT_EQ(hopper_with(kPuller, stiff).morphology.joint_count(), 1);  // the knee is held
}

/// Strider of tests/robots, its legs' upper hinges by servos, all others by tendons over two.
TEST(ActuatorDynamics, ALegWhoseHingesShareTendonsIsRefusedForThat) {
  std::string xml = test::read_file(test::source_path("tests/robots/strider/robot.xml"));
  const ModelPointer model = compile_mjcf(xml, "strider.xml");
  std::string tendons = "<tendon>", actuators = "<actuator>";
  for (int j = 1; j + 2 < model->njnt; j += 3) {  // three hinges a leg
    const auto name = [&](int joint) { return name_of(*model, mjOBJ_JOINT, joint); };
    const std::string of = std::to_string(j);
    tendons += "<fixed name=\"t" + of + "\"><joint joint=\"" + name(j + 1) +
               "\" coef=\"1\"/><joint joint=\"" + name(j + 2) + "\" coef=\"1\"/></fixed>";
    actuators += "<position name=\"a" + of + "\" joint=\"" + name(j) +
                 "\" kp=\"50\"/><position name=\"lift" + of + "\" tendon=\"t" + of +
                 "\" kp=\"50\"/>";
  }
  const std::size_t begin = xml.find("<actuator>"), end = xml.find("</actuator>");
  xml.replace(begin, end - begin, tendons + "</tendon>" + actuators);
  try {
    (void)parse_robot(xml, "strider.xml");
    FAIL() << "legs of which one hinge moves were accepted";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("ends a leg of which 2 hinges would be held"), std::string::npos) << said;
    EXPECT_NE(said.find("like 'lift1'"), std::string::npos) << said;
  }
}

/// The control of a servo is the length of its tendon.
TEST(ActuatorDynamics, KeyframesTellTheTendonsLength) {
  RobotModel robot = hopper_with(kPuller, kAlone);
  robot =
      parse_robot(test::with(robot.xml, "0.5 -0.8\"", "0.5 -0.8\" ctrl=\"0.5 1.6\""), "hopper.xml");
  ASSERT_EQ(robot.space.parameters[0].name, "thigh_length");
  Eigen::VectorXd s = robot.space.initial();
  s[0] = robot.space.parameters[0].lower;
  const ModelPointer model = compile_mjcf(rewrite_robot(robot, s), robot.file);
  const double angle = model->key_qpos[8];
  EXPECT_GT(std::abs(angle + 0.8), 1e-3);
  EXPECT_NEAR(model->key_ctrl[1], -2.0 * angle, 1e-9);
}

}  // namespace
}  // namespace legwright
