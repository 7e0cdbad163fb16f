// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/build_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/link_sizes.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using test::boxy_dog;

double capsule_mass(double length, double radius, double density) {
  return density * std::numbers::pi * radius * radius * (length + 4.0 / 3.0 * radius);
}

double mass_of(const mjModel& model) {
  double mass = 0.0;
  for (int b = 0; b < static_cast<int>(model.nbody); ++b) mass += model.body_mass[b];
  return mass;
}

TEST(AssembledRobot, WeighsItsModulesAndItsLinks) {
  const Assembly assembly = boxy_dog();
  const ModelPointer model = compile_mjcf(assembly_xml(assembly, 0.2), "dog.xml");
  const double link = capsule_mass(0.09, link_radius(assembly), assembly.link_density);
  EXPECT_NEAR(mass_of(*model), 0.4 + 0.2 + 8 * 0.06 + 4 * 0.01 + 8 * link, 1e-9);
}

TEST(AssembledRobot, HasTheFiguresOfItsServos) {
  Assembly assembly = boxy_dog();
  assembly.torque_share = 0.5;
  const ModelPointer model = compile_mjcf(assembly_xml(assembly, 0.2), "dog.xml");
  ASSERT_EQ(model->njnt, 9);
  ASSERT_EQ(model->nu, 8);
  for (int j = 1; j < 9; ++j) {
    EXPECT_EQ(model->dof_armature[model->jnt_dofadr[j]], 0.004);
    EXPECT_EQ(model->jnt_range[2 * j + 1], 2.5);
  }
  EXPECT_NEAR(model->actuator_forcerange[1], 0.75, 1e-12);
  assembly.torque = TorqueLimit::continuous;
  const ModelPointer rated = compile_mjcf(assembly_xml(assembly, 0.2), "dog.xml");
  EXPECT_NEAR(rated->actuator_forcerange[1], 0.25, 1e-12);
  assembly.limbs[0].joints[0].servo.joint->continuous_torque.reset();
  assembly.limbs[0].joints[0].servo.joint->reflected_inertia.reset();
  assembly.armature = 0.01;
  const ModelPointer unknown = compile_mjcf(assembly_xml(assembly, 0.2), "dog.xml");
  EXPECT_NEAR(unknown->actuator_forcerange[1], 0.75, 1e-12) << "the stall torque instead";
  EXPECT_EQ(unknown->dof_armature[unknown->jnt_dofadr[1]], 0.01);
}

/// Left and right are mirror images at equal angles, however the axes lie.
TEST(AssembledRobot, ItsSidesMirrorEachOtherAtEqualAngles) {
  Assembly assembly = boxy_dog();
  assembly.limbs[0].joints[0].axis = Vector3d(1.0, 0.3, -0.4).normalized();
  assembly.limbs[0].joints[1].axis = Vector3d(0.2, 1.0, 0.5).normalized();
  assembly.limbs[0].joints[1].roll = 0.4;
  assembly.limbs[0].joints[1].offset = {0.02, 0.03, -0.08};
  const ModelPointer model = compile_mjcf(assembly_xml(assembly, 0.2), "dog.xml");
  std::vector<double> qpos(model->qpos0, model->qpos0 + model->nq);
  for (const char* joint :
       {"FL_hip", "FR_hip", "FL_knee", "FR_knee", "HL_hip", "HR_hip", "HL_knee", "HR_knee"})
    qpos[static_cast<std::size_t>(
        model->jnt_qposadr[mj_name2id(model.get(), mjOBJ_JOINT, joint)])] =
        joint[3] == 'h' ? 0.5 : -0.8;
  const DataPointer data = kinematics_at(*model, qpos.data(), "dog.xml");
  for (const char* body : {"hip_servo", "hip_link", "knee_servo", "knee_link"}) {
    const int left = mj_name2id(model.get(), mjOBJ_BODY, (std::string("FL_") + body).c_str()),
              right = mj_name2id(model.get(), mjOBJ_BODY, (std::string("FR_") + body).c_str());
    ASSERT_TRUE(left > 0 && right > 0) << body;
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(data->xipos[3 * left + k], (k == 1 ? -1.0 : 1.0) * data->xipos[3 * right + k],
                  1e-10)
          << body;
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(model->body_inertia[3 * left + k], model->body_inertia[3 * right + k], 1e-13);
  }
}

/// The horn sits at the joint and looks along its axis; the servo's body lies towards the joint
/// above.
TEST(AssembledRobot, PutsServosOnWhatCarriesThem) {
  const ModelPointer model = compile_mjcf(assembly_xml(boxy_dog(), 0.2), "dog.xml");
  const int servo = mj_name2id(model.get(), mjOBJ_BODY, "FL_knee_servo");
  EXPECT_EQ(model->body_parentid[servo], mj_name2id(model.get(), mjOBJ_BODY, "FL_hip_link"));
  EXPECT_EQ(model->body_jntnum[servo], 0);
  const double* centre = model->body_ipos + std::ptrdiff_t{3} * servo;
  EXPECT_NEAR(centre[0], 0.0, 1e-12);
  EXPECT_NEAR(centre[1], -0.017, 1e-12) << "behind its horn";
  EXPECT_NEAR(centre[2], 0.009, 1e-12) << "up the thigh";
}

TEST(BuiltRobots, StandAndDeclareWhatMayChange) {
  const BuiltRobot built = build_robot(boxy_dog(), "dog.xml");
  EXPECT_NE(built.pose, "") << "stretched legs are bent";
  const RobotModel& robot = built.found.model;
  EXPECT_EQ(robot.morphology.foot_count(), 4);
  for (const char* name : {"front_hip_link_length", "hind_knee_link_length", "front_hip_axis_yaw",
                           "body_length", "body_width"})
    EXPECT_GE(robot.space.find(name), 0) << name;
  const ModelPointer model = compile_mjcf(built.xml, "dog.xml");
  const int key = mj_name2id(model.get(), mjOBJ_KEY, "home");
  ASSERT_EQ(key, 0);
  const DataPointer data = kinematics_at(*model, model->key_qpos, "dog.xml");
  for (const char* foot : {"FL", "FR", "HL", "HR"})
    EXPECT_NEAR(lowest_point(*model, *data, mj_name2id(model.get(), mjOBJ_GEOM, foot)), 0.0, 2e-6);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(model->key_ctrl[i], model->key_qpos[7 + i]);
  EXPECT_EQ(build_robot(boxy_dog(), "dog.xml").xml, built.xml) << "same input, same bytes";
}

/// What is declared can be written for another design: a longer thigh weighs more, servos do not.
TEST(BuiltRobots, FollowTheirDesign) {
  const BuiltRobot built = build_robot(boxy_dog(), "dog.xml");
  const RobotModel& robot = built.found.model;
  Eigen::VectorXd s = robot.space.initial();
  s[robot.space.find("front_hip_link_length")] += 0.01;
  s[robot.space.find("body_length")] += 0.005;
  const ModelPointer before = compile_mjcf(built.xml, "dog.xml"),
                     after = compile_mjcf(rewrite_robot(robot, s), "dog.xml");
  EXPECT_NEAR(mass_of(*after) - mass_of(*before),
              2.0 * (capsule_mass(0.1, 0.006, 1240.0) - capsule_mass(0.09, 0.006, 1240.0)), 1e-9);
  const int servo = mj_name2id(after.get(), mjOBJ_BODY, "FL_hip_servo"),
            knee = mj_name2id(after.get(), mjOBJ_BODY, "FL_knee_servo");
  EXPECT_NEAR(after->body_pos[std::ptrdiff_t{3} * servo], 0.0925, 1e-9) << "hips go with the trunk";
  EXPECT_NEAR(after->body_pos[3 * knee + 2], -0.1, 1e-9);
  EXPECT_EQ(after->body_mass[knee], before->body_mass[knee]);
}

TEST(BuiltRobots, KeepAPoseThatStands) {
  Assembly assembly = boxy_dog();
  assembly.limbs[0].joints[1].offset = {-0.04, 0.0, -0.075};
  assembly.limbs[0].foot_offset = {0.04, 0.0, -0.08};
  const BuiltRobot built = build_robot(assembly, "dog.xml");
  EXPECT_EQ(built.pose, "");
  const ModelPointer model = compile_mjcf(built.xml, "dog.xml");
  EXPECT_NEAR(model->key_qpos[2], 0.075 + 0.08 + 0.012, 1e-6);
  EXPECT_EQ(model->key_qpos[7], 0.0);
}

TEST(BuiltRobots, SayWhatIsNotKnownOfTheirServos) {
  EXPECT_TRUE(build_robot(boxy_dog(), "dog.xml").notes.empty());
  Assembly assembly = boxy_dog();
  assembly.torque = TorqueLimit::continuous;
  for (AssemblyJoint& joint : assembly.limbs[0].joints) {
    joint.servo.joint->reflected_inertia.reset();
    joint.servo.joint->continuous_torque.reset();
  }
  const std::vector<std::string> notes = build_robot(assembly, "dog.xml").notes;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_NE(notes[0].find("reflected inertia is not known and taken as"), std::string::npos);
  EXPECT_NE(notes[1].find("the stall torque is the limit"), std::string::npos);
}

std::string first_note(const Assembly& assembly) {
  const std::vector<std::string> notes = build_robot(assembly, "dog.xml").notes;
  return notes.empty() ? "" : notes[0];
}

/// It follows the stall torque, and is none of brushless joints.
TEST(BuiltRobots, TakeAnArmatureByTheStallTorque) {
  Assembly assembly = boxy_dog();
  for (AssemblyJoint& joint : assembly.limbs[0].joints) {
    joint.servo.joint->reflected_inertia.reset();
    joint.servo.joint->stall_torque = 4.0;
  }
  EXPECT_NE(first_note(assembly).find("taken as 0.02 kg m2 of S: 0.005 for each N m"),
            std::string::npos)
      << first_note(assembly);
  const auto armature = [&] {
    const ModelPointer model = compile_mjcf(build_robot(assembly, "dog.xml").xml, "dog.xml");
    return model->dof_armature[model->jnt_dofadr[1]];
  };
  EXPECT_DOUBLE_EQ(armature(), 0.02);
  assembly.armature = 0.01;
  EXPECT_DOUBLE_EQ(armature(), 0.01);
  EXPECT_EQ(first_note(assembly), "");
  assembly.armature.reset();
  assembly.limbs[0].joints[1].servo.name = "T";
  assembly.limbs[0].joints[1].servo.joint->stall_torque = 2.0;
  EXPECT_NE(first_note(assembly).find("0.01 kg m2 of T, 0.02 kg m2 of S: "), std::string::npos)
      << first_note(assembly);
  for (AssemblyJoint& joint : assembly.limbs[0].joints) joint.servo.joint->gear_ratio = 9.0;
  EXPECT_NE(first_note(assembly).find("rotor inertia times the square of the ratio"),
            std::string::npos)
      << first_note(assembly);
  EXPECT_EQ(armature(), 0.0);
}

TEST(BuiltRobots, SayWhatFrictionIsAssumedOfAFoot) {
  Assembly assembly = boxy_dog();
  assembly.limbs[0].foot.friction.reset();
  EXPECT_NE(first_note(assembly).find("the friction of ball is not known: 0.8 is assumed"),
            std::string::npos)
      << first_note(assembly);
}

TEST(BuiltRobots, RefuseLimbsThatDoNotStand) {
  Assembly assembly = boxy_dog();
  assembly.limbs[0].joints[1].offset = {0.0, 0.0, 0.09};
  assembly.limbs[0].foot_offset = {0.0, 0.0, 0.09};
  assembly.limbs[0].joints[0].range = {-0.1, 0.1};
  assembly.limbs[0].joints[1].range = {-0.1, 0.1};
  EXPECT_THROW((void)build_robot(assembly, "dog.xml"), InputError);
}

/// A range without zero is one of a limb that is never as it is drawn.
TEST(BuiltRobots, StandWithinRangesWithoutZeroOrSayWhyNot) {
  Assembly dog = test::boxy_dog();
  dog.limbs[0].joints[1].range = {-2.0, -0.3};
  EXPECT_NE(build_robot(dog, "dog.xml").pose, "") << "knees that do not stretch are bent";
  dog.limbs[0].joints[0].range = {1.5, 1.6};
  dog.limbs[0].joints[1].range = {1.5, 1.6};
  try {
    (void)build_robot(dog, "dog.xml");
    FAIL();
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_NE(
        told.find("joint \"hip\" of limb \"FL\" has the range [1.5, 1.6], outside of which it "
                  "is drawn, at zero, and no pose is found"),
        std::string::npos)
        << told;
  }
}

TEST(PlacedLimbs, AreNamedLeftBeforeRight) {
  Assembly assembly = boxy_dog();
  assembly.limbs[0].hip.y() = -0.07;  // the right one is drawn
  std::vector<std::string> names;
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    names.push_back(limb.name);
    EXPECT_EQ(limb.hip.y() > 0.0, limb.name.back() == 'L');
  }
  EXPECT_EQ(names, (std::vector<std::string>{"FL", "FR", "HL", "HR"}));
}

}  // namespace
}  // namespace legwright
