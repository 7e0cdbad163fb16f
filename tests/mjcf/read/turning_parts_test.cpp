// SPDX-License-Identifier: Apache-2.0
// Servos that turn with their joint's axis: in F, in the file that is written, refused.
#include "mjcf/read/turning_parts.hpp"

#include <gtest/gtest.h>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/read/connectors.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "mjcf/write/verify.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::error_message;
using test::hulled_dog;

/// A design with all axes turned and lengths changed.
VectorXd askew(const RobotModel& robot) {
  VectorXd s = robot.space.initial();
  int axes = 0;
  for (int k = 0; k < robot.space.size(); ++k) {
    const DesignParameter& parameter = robot.space.parameters[k];
    if (parameter.kind == ParameterKind::axis_angle)
      s[k] = ++axes % 2 ? 0.4 : -0.7;
    else
      s[k] = 0.3 * parameter.lower + 0.7 * parameter.upper;
  }
  EXPECT_EQ(axes, 8) << "of two joints, front and hind, about two directions";
  return s;
}

int id_of(const mjModel& model, mjtObj kind, const std::string& name) {
  const int id = mj_name2id(&model, kind, name.c_str());
  EXPECT_GE(id, 0) << name;
  return id;
}

/// Without hulls F is exact: what is written weighs what F says, moments and all.
TEST(TurningParts, WeighInFAsInTheFileThatIsWritten) {
  const BuiltRobot built = build_robot(test::boxy_dog(), "dog.xml");
  const RobotModel& robot = built.found.model;
  EXPECT_EQ(robot.turning_parts.size(), 8u);
  const VectorXd s = askew(robot);
  const RobotModel written = parse_robot(rewrite_robot(robot, s), "dog.xml");
  EXPECT_EQ(find_difference(robot.morphology, s, written.morphology, s, 1e-10), "");
  // From there on to another design and back.
  const VectorXd initial = robot.space.initial();
  EXPECT_EQ(find_difference(robot.morphology, initial, written.morphology, initial, 1e-10), "");
  Morphology still = robot.morphology;
  for (Link& link : still.links)
    for (PointMass& point : link.masses) point.arm.turns.clear();
  EXPECT_NE(find_difference(still, s, written.morphology, s, 1e-3), "") << "they matter";
}

TEST(TurningParts, LookAlongTheAxis) {
  const BuiltRobot built = build_robot(hulled_dog(), "dog.xml");
  const RobotModel& robot = built.found.model;
  const std::string text = rewrite_robot(robot, askew(robot));
  const ModelPointer before = compile_mjcf(built.xml, "dog.xml"),
                     after = compile_mjcf(text, "dog.xml");
  for (const char* const limb : {"FL", "FR", "HL", "HR"})
    for (const char* const joint : {"_hip", "_knee"}) {
      const int hinge = id_of(*after, mjOBJ_JOINT, std::string(limb) + joint),
                servo = id_of(*after, mjOBJ_BODY, std::string(limb) + joint + "_servo");
      const Vector3d drawn = vector_at(before->jnt_axis, hinge),
                     turned = vector_at(after->jnt_axis, hinge);
      EXPECT_GT((drawn - turned).norm(), 0.3);
      const Matrix3d pose =
          rotation_at(after->body_quat, servo) * rotation_at(before->body_quat, servo).transpose();
      EXPECT_LT((pose * drawn - turned).norm(), 1e-11) << limb << joint;
      EXPECT_EQ(vector_at(after->body_pos, servo),
                vector_at(after->body_pos, after->jnt_bodyid[hinge]));
    }
}

/// The pads on a horn stay on its plane, those on the next servo on that.
TEST(TurningParts, TakeTheConnectorsAlong) {
  const BuiltRobot built = build_robot(hulled_dog(), "dog.xml");
  const RobotModel& robot = built.found.model;
  const VectorXd s = askew(robot);
  const std::string text = rewrite_robot(robot, s);
  const RobotModel written = parse_robot(text, "dog.xml");
  EXPECT_EQ(find_difference(with_hulls_at(robot, s), s, written.morphology, s, 1e-9), "");
  const auto height = [](const RobotModel& of, std::size_t k, std::size_t end, std::size_t point) {
    const Connector& connector = of.connectors[k];
    const std::string& joint = connector.ends[end].joint;
    for (const Link& link : of.morphology.links)
      if (link.joint.name == joint)
        return link.joint.axis.at(of.space.initial()).dot(connector.ends[end].points[point]);
    ADD_FAILURE() << connector.mesh << ": no joint " << joint;
    return 0.0;
  };
  ASSERT_EQ(written.connectors.size(), robot.connectors.size());
  int looked_at = 0;
  for (std::size_t k = 0; k < robot.connectors.size(); ++k)
    for (std::size_t end = 0; end < robot.connectors[k].ends.size(); ++end) {
      if (robot.connectors[k].ends[end].joint.empty()) continue;  // at a foot
      for (std::size_t point = 0; point < robot.connectors[k].ends[end].points.size(); ++point)
        EXPECT_NEAR(height(robot, k, end, point), height(written, k, end, point), 1e-11);
      ++looked_at;
    }
  EXPECT_GE(looked_at, 12) << "eight horns, four knees";
  // From there back, it is the file's robot again.
  const RobotModel back = parse_robot(rewrite_robot(written, robot.space.initial()), "dog.xml");
  const VectorXd initial = robot.space.initial();
  EXPECT_EQ(find_difference(robot.morphology, initial, back.morphology, initial, 1e-9), "");
}

/// An arm that is held turns with nothing, and its servos are no hindrance.
TEST(TurningParts, OfJointsThatAreHeldStay) {
  Assembly dog = test::boxy_dog();
  AssemblyLimb arm = dog.limbs[0];
  arm.names = {"arm"};
  arm.hip = {0.05, 0.0, 0.04};
  arm.mirrored = false;
  for (AssemblyJoint& joint : arm.joints) {
    joint.offset *= -1.0;
    joint.servo.joint->no_load_speed = 6.0;  // its motor line is passed over likewise
  }
  arm.foot_offset = {0.0, 0.0, 0.09};
  dog.limbs.push_back(arm);
  const RobotModel robot = build_robot(dog, "dog.xml").found.model;
  EXPECT_EQ(robot.turning_parts.size(), 8u) << "of the legs";
  EXPECT_EQ(robot.morphology.joint_count(), 8);
}

TEST(TurningParts, AreRefusedWhereTheyCannotTurn) {
  const std::string text = assembly_xml(test::boxy_dog(), 0.2);
  const auto refused = [&](const std::string& was, const std::string& is) {
    std::string changed = text;
    const std::size_t at = changed.find(was);
    EXPECT_NE(at, std::string::npos) << was;
    changed.replace(at, was.size(), is);
    return error_message(changed);
  };
  const std::string own = "legwright_turns/FL_hip_servo\" data=\"joint FL_hip\"";
  const auto expect = [&](const std::string& is, const char* what) {
    const std::string message = refused(own, is);
    EXPECT_NE(message.find(what), std::string::npos) << message;
    EXPECT_NE(message.find("text 'legwright_turns/"), std::string::npos) << message;
  };
  expect("legwright_turns/nobody\" data=\"joint FL_hip\"", "none of the robot below its trunk");
  expect("legwright_turns/trunk\" data=\"joint FL_hip\"", "none of the robot below its trunk");
  expect("legwright_turns/FL_hip_link\" data=\"joint FL_hip\"", "has a joint");
  expect("legwright_turns/FL_hip_servo\" data=\"joint nobody\"", "is no hinge");
  expect("legwright_turns/FL_hip_servo\" data=\"FL_hip\"", "expected \"joint NAME\"");
  expect("legwright_turns/FL_hip_servo\" data=\"joint FR_hip\"", "is not at joint 'FR_hip'");
  expect("legwright_turns/FL_hip_servo\" data=\"joint FL_knee\"", "is not at joint 'FL_knee'");
  const std::string place = "<body name=\"FL_hip_servo\" pos=\"0.09 0.07 0\">";
  EXPECT_NE(refused(place, place + "<site/>").find("has a site"), std::string::npos);
  std::string framed = text;
  framed.insert(framed.find(place), "<frame>");
  framed.insert(framed.find("</body>", framed.find(place)) + 7, "</frame>");
  EXPECT_NE(error_message(framed).find("is in a frame"), std::string::npos);
  std::string stretched = build_robot(test::boxy_dog(), "dog.xml").xml;
  stretched.replace(stretched.find(own), own.size(),
                    "legwright_turns/FL_hip_link\" data=\"joint FL_hip\"");
  EXPECT_NE(error_message(stretched).find("is stretched"), std::string::npos);
  const std::string holds = refused("<body name=\"FL_hip_servo\" pos=\"0.09 0.07 0\">",
                                    "<body name=\"FL_hip_servo\" pos=\"0.09 0.07 0\"><body/>");
  EXPECT_NE(holds.find("holds other bodies"), std::string::npos) << holds;
}

}  // namespace
}  // namespace legwright
