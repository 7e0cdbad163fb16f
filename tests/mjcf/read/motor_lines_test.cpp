// SPDX-License-Identifier: Apache-2.0
// Motors whose torque falls with speed: read from the file, told what is wrong, handed to F and to
// the plugin.
#include "mjcf/read/motor_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// The puppy with a numeric of this name and data.
RobotModel puppy_with(const std::string& name, const std::string& data) {
  std::string xml = test::example_robot("puppy");
  const auto end = xml.rfind("</mujoco>");
  return parse_robot(
      xml.insert(end, "<custom><numeric name=\"" + name + "\" data=\"" + data + "\"/></custom>"),
      "puppy.xml");
}

std::string refusal(const std::string& name, const std::string& data) {
  try {
    (void)puppy_with(name, data);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<Servo> servos_of(const Assembly& assembly) {
  return parse_robot(build_robot(assembly, "dog.toml").xml, "dog.xml").servos;
}

TEST(MotorLines, BelongToTheirJointAlone) {
  const RobotModel plain = parse_robot(test::example_robot("puppy"), "puppy.xml");
  const std::string joint = plain.servos[1].joint;
  const RobotModel robot = puppy_with("legwright_motor/" + joint, "40 6.5");
  for (std::size_t k = 0; k < robot.servos.size(); ++k) {
    EXPECT_EQ(robot.servos[k].line.has_value(), k == 1);
    EXPECT_EQ(robot.morphology.links[k + 1].joint.line.has_value(), k == 1);
  }
  EXPECT_EQ(robot.morphology.links[2].joint.line->stall_torque, 40.0);
  EXPECT_EQ(robot.morphology.links[2].joint.line->no_load_speed, 6.5);
  EXPECT_EQ(robot.servos[1].torque_limit, plain.servos[1].torque_limit);
  EXPECT_FALSE(puppy_with("motor_of_mine", "1 2 3").servos[1].line);
}

TEST(MotorLines, AreRefusedWithTheReason) {
  const std::string joint = parse_robot(test::example_robot("puppy"), "puppy.xml").servos[1].joint;
  const std::string of_joint = "legwright_motor/" + joint;
  EXPECT_NE(refusal("legwright_motor/nobody", "40 6").find("joint 'nobody', which no servo"),
            std::string::npos);
  for (const char* data : {"40", "40 6 1", "40 -6", "0 6"})
    EXPECT_NE(refusal(of_joint, data).find("expected two positive numbers"), std::string::npos)
        << data << ": " << refusal(of_joint, data);
  EXPECT_NE(refusal(of_joint, "0.01 6").find("lower its forcerange"), std::string::npos)
      << refusal(of_joint, "0.01 6");
}

/// Of a linear actuator they are force and speed along it, and none of its hinge.
TEST(MotorLines, OfLinearActuatorsAreForceAndSpeed) {
  const std::string xml = test::example_robot("piston_puppy");
  const auto with = [&](const std::string& data) {
    std::string text = xml;
    return parse_robot(text.insert(text.rfind("</mujoco>"),
                                   "<custom><numeric name=\"legwright_motor/FL_knee\" data=\"" +
                                       data + "\"/></custom>"),
                       "piston_puppy.xml");
  };
  const RobotModel robot = with("200 0.05");
  int found = 0;
  for (const LinearActuator& actuator : robot.morphology.linear_actuators) {
    const Joint& joint = robot.morphology.links[static_cast<std::size_t>(actuator.joint) + 1].joint;
    ASSERT_EQ(joint.line.has_value(), joint.name == "FL_knee");
    if (!joint.line) continue;
    ++found;
    EXPECT_EQ(joint.line->stall_torque, 200.0);
    EXPECT_EQ(joint.line->no_load_speed, 0.05);
    EXPECT_TRUE(std::isinf(joint.torque_limit)) << "its force is limited";
  }
  EXPECT_EQ(found, 1);
  try {
    (void)with("20 0.05");
    FAIL() << "less than its force limit";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("has 20 N at rest, less than the force limit"),
              std::string::npos)
        << error.what();
  }
}

TEST(MotorLines, ComeFromTheModulesOfAnAssembly) {
  Assembly dog = test::boxy_dog();
  for (const Servo& servo : servos_of(dog)) EXPECT_FALSE(servo.line) << servo.joint;
  for (AssemblyJoint& joint : dog.limbs[0].joints) joint.servo.joint->no_load_speed = 7.0;
  for (const Servo& servo : servos_of(dog)) {
    ASSERT_TRUE(servo.line) << servo.joint;
    EXPECT_EQ(servo.line->stall_torque, 1.5);
    EXPECT_EQ(servo.line->no_load_speed, 7.0);
  }
}

}  // namespace
}  // namespace legwright
