// SPDX-License-Identifier: Apache-2.0
// What a URDF leaves open, or says of no body, is mended and told.
#include "mjcf/urdf/mend_urdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/urdf/hopper.hpp"

namespace legwright {
namespace {

using test::kHopper;
using test::made;
using test::tells;

TEST(MendUrdf, NoBodyHasMomentsThatMujocoRefuses) {
  const MjcfOfUrdf mended = made(test::with(kHopper, "ixx=\"0.001\"", "ixx=\"0.009\""));
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  const int thigh = mj_name2id(model.get(), mjOBJ_BODY, "thigh");
  EXPECT_NEAR(model->body_inertia[3 * thigh], (0.009 + 0.001 + 0.0001) / 3, 1e-12);
  EXPECT_TRUE(tells(mended.notes[1], "moments of inertia of thigh")) << mended.notes[1];
}

TEST(MendUrdf, ALinkThatMovesWithoutMassGetsThatOfWhatIsFixedToIt) {
  std::string urdf = test::with(kHopper, "<link name=\"trunk\">", "<link name=\"core\">");
  urdf =
      test::with(urdf, "</robot>",
                 "<link name=\"trunk\"><visual><geometry><sphere radius=\"0.03\"/></geometry>"
                 "</visual></link><joint name=\"core\" type=\"fixed\"><origin xyz=\"0.1 0 0\" "
                 "rpy=\"0 0 1\"/><parent link=\"trunk\"/><child link=\"core\"/></joint></robot>");
  const ModelPointer model = compile_mjcf(made(urdf).text, "hopper.xml"),
                     plain = compile_mjcf(made(kHopper).text, "hopper.xml");
  const int trunk = mj_name2id(model.get(), mjOBJ_BODY, "trunk"),
            core = mj_name2id(model.get(), mjOBJ_BODY, "core"),
            before = mj_name2id(plain.get(), mjOBJ_BODY, "trunk");
  ASSERT_TRUE(trunk > 0 && core > 0);
  EXPECT_EQ(model->body_mass[trunk], 2.0);
  EXPECT_EQ(model->body_mass[core], 0.0);
  EXPECT_LT((vector_at(model->body_ipos, trunk) - Eigen::Vector3d(0.1, 0, 0.01)).norm(), 1e-12);
  EXPECT_LT((vector_at(model->body_inertia, trunk) - vector_at(plain->body_inertia, before)).norm(),
            1e-12);
  // The moments' axes are turned with the link: by 0.5 as the URDF has them, and by 1.
  const auto axes = [](const mjModel& of, int body) -> Eigen::Matrix3d {
    const Eigen::Matrix3d r = rotation_at(of.body_iquat, body);
    return r * vector_at(of.body_inertia, body).asDiagonal() * r.transpose();
  };
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_LT((axes(*model, trunk) - turn * axes(*plain, before) * turn.transpose()).norm(), 1e-12);
}

/// As people put a robot upright that its CAD program exported with y up.
TEST(MendUrdf, ALinkWithoutMassThatTurnsTheRobotIsItsTrunk) {
  const MjcfOfUrdf upright = made(test::with(
      kHopper, "type=\"fixed\"><parent link=\"mount\"",
      "type=\"fixed\"><origin xyz=\"0 0 0\" rpy=\"1.5708 0 0\"/><parent link=\"mount\""));
  const ModelPointer model = compile_mjcf(upright.text, "hopper.xml");
  const int mount = mj_name2id(model.get(), mjOBJ_BODY, "mount"),
            trunk = mj_name2id(model.get(), mjOBJ_BODY, "trunk");
  ASSERT_TRUE(mount > 0 && trunk > 0) << upright.text;
  EXPECT_EQ(model->jnt_type[model->body_jntadr[mount]], mjJNT_FREE);
  EXPECT_EQ(model->body_parentid[trunk], mount);
  EXPECT_EQ(model->body_mass[mount], 2.0);
  EXPECT_NEAR(rotation_at(model->body_quat, trunk)(2, 1), 1.0, 1e-4);
}

/// As the exporters of CAD programs leave them.
TEST(MendUrdf, JointsWithoutEffortGetMotorsThatCarryTheRobot) {
  const std::string urdf = test::with(kHopper, "effort=\"6\"", "effort=\"0\"");
  const RobotModel robot = parse_robot(made(urdf).text, "hopper.urdf");
  const UrdfMending mending = mending_of(robot, {});
  const MjcfOfUrdf mended = mjcf_of_urdf(urdf, "hopper.urdf", mending);
  EXPECT_TRUE(tells(mended.notes[1], "hip has no <limit effort> above 0: the motor gets "))
      << mended.notes[1];
  const ModelPointer model = compile_mjcf(mended.text, "hopper.urdf");
  const int hip = mj_name2id(model.get(), mjOBJ_ACTUATOR, "hip");
  ASSERT_GE(hip, 0);
  EXPECT_NEAR(model->actuator_forcerange[2 * hip + 1], mending.most_torque, 1e-9);
}

TEST(MendUrdf, PlaceholdersGiveNoGainsAndOverlappingShapesMayPass) {
  std::string urdf = test::with(kHopper, "effort=\"6\"", "effort=\"1000\"");
  const std::string shape =
      "<collision><geometry><box size=\"0.02 0.02 0.3\"/></geometry></collision>";
  urdf = test::with(urdf, "<link name=\"shank\">", "<link name=\"shank\">" + shape);
  const RobotModel robot = parse_robot(made(urdf).text, "hopper.urdf");
  const UrdfMending mending = mending_of(robot, {});
  EXPECT_NEAR(mending.most_torque, 2 * 9.81 * 2.5 * robot.morphology.leg_length, 1e-9);
  ASSERT_EQ(mending.overlapping.size(), 1u);
  EXPECT_EQ(mending.overlapping[0].first, "trunk");
  EXPECT_EQ(mending.overlapping[0].second, "shank");
  const MjcfOfUrdf mended = mjcf_of_urdf(urdf, "hopper.urdf", mending);
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  EXPECT_NEAR(model->actuator_gainprm[0], mending.most_torque / kFullTorqueError, 1e-6);
  EXPECT_EQ(model->actuator_forcerange[1], 1000.0);  // the limit is the user's
  EXPECT_EQ(model->nexclude, 1);
  EXPECT_TRUE(touching_bodies(*model, "hopper.xml").empty());
}

std::string all_notes(const MjcfOfUrdf& made) {
  std::string out;
  for (const std::string& note : made.notes) out += note + "\n";
  return out;
}

/// Read a second time, as `legwright init` does.
MjcfOfUrdf made_twice(const std::string& urdf) {
  const MjcfOfUrdf first = made(urdf);
  const RobotModel robot = parse_robot(first.text, "hopper.urdf");
  return mjcf_of_urdf(urdf, "hopper.urdf", mending_of(robot, first.without_moments));
}

Eigen::Vector3d moments(const MjcfOfUrdf& made, const char* body) {
  const ModelPointer model = compile_mjcf(made.text, "hopper.xml");
  const int id = mj_name2id(model.get(), mjOBJ_BODY, body);
  const Eigen::Matrix3d axes = rotation_at(model->body_iquat, id);
  return (axes * vector_at(model->body_inertia, id).asDiagonal() * axes.transpose()).diagonal();
}

/// As robots have it whose base stands on a footprint: masses behind a link that has none.
TEST(MendUrdf, TheMassOfALinkIsFoundBehindOthers) {
  std::string urdf = test::with(kHopper, "<link name=\"trunk\">", "<link name=\"core\">");
  urdf = test::with(
      urdf, "</robot>",
      "<link name=\"trunk\"><visual><geometry><sphere radius=\"0.03\"/></geometry></visual></link>"
      "<link name=\"plate\"/>"
      "<joint name=\"a\" type=\"fixed\"><origin xyz=\"0.1 0 0\" rpy=\"0 0 1\"/>"
      "<parent link=\"trunk\"/><child link=\"plate\"/></joint>"
      "<joint name=\"b\" type=\"fixed\"><origin xyz=\"0.2 0 0\"/>"
      "<parent link=\"plate\"/><child link=\"core\"/></joint></robot>");
  const MjcfOfUrdf found = made(urdf);
  const ModelPointer model = compile_mjcf(found.text, "hopper.xml");
  const int trunk = mj_name2id(model.get(), mjOBJ_BODY, "trunk");
  EXPECT_EQ(model->body_mass[trunk], 2.0);
  const Eigen::Vector3d centre(0.1 + 0.2 * std::cos(1.0), 0.2 * std::sin(1.0), 0.01);
  EXPECT_LT((vector_at(model->body_ipos, trunk) - centre).norm(), 1e-12);
  EXPECT_TRUE(tells(all_notes(found), "'trunk' moves and has no mass: it gets that of 'core'"));
}

TEST(MendUrdf, AMassOfZeroIsNone) {
  const std::string urdf = test::with(
      kHopper, "<link name=\"mount\"/>",
      "<link name=\"mount\"><inertial><mass value=\"0\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" "
      "iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>");
  EXPECT_TRUE(tells(made(urdf).notes[0], "'mount' has no mass and is left out"));
}

/// m/12 (b² + c²) of the box that is the trunk's shape.
const Eigen::Vector3d kBoxOfTrunk =
    2.0 / 12.0 * Eigen::Vector3d(0.01 + 0.0016, 0.04 + 0.0016, 0.04 + 0.01);

TEST(MendUrdf, MomentsOfZeroBecomeThoseOfABoxAroundTheShape) {
  const std::string urdf = test::with(
      kHopper, "ixx=\"0.01\" ixy=\"0.001\" ixz=\"0\" iyy=\"0.02\" iyz=\"0\" izz=\"0.025\"",
      "ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"");
  ASSERT_NE(urdf, kHopper);
  ASSERT_EQ(made(urdf).without_moments, std::vector<std::string>{"trunk"});
  const MjcfOfUrdf mended = made_twice(urdf);
  EXPECT_LT((moments(mended, "trunk") - kBoxOfTrunk).norm(), 1e-12);
  EXPECT_TRUE(tells(all_notes(mended), "moments of inertia of trunk are 0: they get"));
  EXPECT_TRUE(mended.without_moments.empty());
}

TEST(MendUrdf, MomentsThatNoShapeTellsAreThoseOfABall) {
  const std::string urdf = test::with(
      kHopper, "ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.001\" iyz=\"0\" izz=\"0.0001\"",
      "ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"");
  const MjcfOfUrdf mended = made_twice(urdf);
  EXPECT_LT((moments(mended, "thigh") - Eigen::Vector3d::Constant(0.3 * 0.4 * 0.0025)).norm(),
            1e-12);
  EXPECT_TRUE(tells(all_notes(mended), "thigh are 0, and no shape tells them"));
}

TEST(MendUrdf, MomentsOfAMuchLargerBodyBecomeThoseOfABox) {
  const std::string urdf = test::with(
      kHopper, "ixx=\"0.01\" ixy=\"0.001\" ixz=\"0\" iyy=\"0.02\" iyz=\"0\" izz=\"0.025\"",
      "ixx=\"100\" ixy=\"0\" ixz=\"0\" iyy=\"100\" iyz=\"0\" izz=\"100\"");
  EXPECT_NEAR(moments(made(urdf), "trunk").x(), 100.0, 1e-9) << "before the robot is known";
  const MjcfOfUrdf mended = made_twice(urdf);
  EXPECT_LT((moments(mended, "trunk") - kBoxOfTrunk).norm(), 1e-12);
  EXPECT_TRUE(tells(all_notes(mended), "trunk are those of a body many times as large"));
  EXPECT_LT((moments(made_twice(kHopper), "trunk") - moments(made(kHopper), "trunk")).norm(),
            1e-12);
}

TEST(MendUrdf, AJointThatFloatsBelowALinkIsFixed) {
  const MjcfOfUrdf fixed = made(test::with(kHopper, "<joint name=\"tip\" type=\"fixed\">",
                                           "<joint name=\"tip\" type=\"floating\">"));
  const ModelPointer model = compile_mjcf(fixed.text, "hopper.xml");
  EXPECT_EQ(model->njnt, 3);  // the root's, hip and knee
  EXPECT_TRUE(tells(all_notes(fixed), "as the robot as a whole floats: tip is fixed"));
}

/// As robots have it whose root floats in a world of their own, with a picture of it.
TEST(MendUrdf, AFloatingLinkGivesItsMassToTheLinkAbove) {
  std::string urdf = test::with(kHopper, "<link name=\"mount\"/>",
                                "<link name=\"mount\"><visual><geometry><sphere radius=\"0.01\"/>"
                                "</geometry></visual></link>");
  urdf = test::with(urdf, "<joint name=\"rest\" type=\"fixed\">",
                    "<joint name=\"rest\" type=\"floating\">");
  const MjcfOfUrdf mended = made(urdf);
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  EXPECT_EQ(model->njnt, 3);
  EXPECT_EQ(model->body_mass[mj_name2id(model.get(), mjOBJ_BODY, "mount")], 2.0);
  EXPECT_TRUE(tells(all_notes(mended), "rest is fixed")) << all_notes(mended);
}

TEST(MendUrdf, ANegativeMassIsNotTakenForNone) {
  EXPECT_THROW(compile_mjcf(made(test::with(kHopper, "value=\"2\"", "value=\"-2\"")).text, "h.xml"),
               InputError);
}

/// 0.0004 kg m² for each N m at which gains saturate.
TEST(MendUrdf, ServosHaveReflectedInertia) {
  const MjcfOfUrdf mended = made_twice(test::with(kHopper, "effort=\"6\"", "effort=\"1000\""));
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  const int hip = model->jnt_dofadr[mj_name2id(model.get(), mjOBJ_JOINT, "hip")],
            knee = model->jnt_dofadr[mj_name2id(model.get(), mjOBJ_JOINT, "knee")];
  EXPECT_NEAR(model->dof_armature[knee], 0.0004 * 4.0, 1e-12);
  const RobotModel robot = parse_robot(mended.text, "hopper.xml");
  EXPECT_NEAR(model->dof_armature[hip], 0.0004 * mending_of(robot, {}).most_torque, 1e-9)
      << "not that of a placeholder";
}

}  // namespace
}  // namespace legwright
