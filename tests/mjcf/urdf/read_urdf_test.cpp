// SPDX-License-Identifier: Apache-2.0
// The MJCF that is made of a URDF is the robot that MuJoCo itself reads from it, but for what is
// said to be mended.
#include "mjcf/urdf/read_urdf.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/urdf/urdf_meshes.hpp"
#include "mjcf/urdf/write_urdf.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool tells(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const char* const kHead = R"(<?xml version="1.0"?>
<!-- a <robot> in a comment -->
<robot name="hopper">
  <material name="red"><color rgba="0.8 0.1 0.1 1"/></material>
  <link name="mount"/>
  <joint name="rest" type="fixed"><parent link="mount"/><child link="trunk"/></joint>
  <link name="trunk">
    <inertial><origin xyz="0 0 0.01" rpy="0 0 0.5"/><mass value="2"/>
      <inertia ixx="0.01" ixy="0.001" ixz="0" iyy="0.02" iyz="0" izz="0.025"/></inertial>
    <visual><geometry><box size="0.2 0.1 0.04"/></geometry><material name="red"/></visual>
    <collision name="shell"><geometry><box size="0.2 0.1 0.04"/></geometry></collision>
  </link>
)";
const char* const kLeg = R"(
  <link name="thigh">
    <inertial><origin xyz="0 0 -0.05"/><mass value="0.3"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.0001"/></inertial>
  </link>
  <joint name="hip" type="revolute"><origin xyz="0 0 -0.02" rpy="0 0.1 0"/>
    <parent link="trunk"/><child link="thigh"/><axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.5" effort="6" velocity="20"/><dynamics damping="0.1" friction="0.02"/>
  </joint>
  <link name="thigh_plate"/>
  <joint name="plate" type="fixed"><parent link="thigh"/><child link="thigh_plate"/></joint>
  <link name="shank">
    <inertial><origin xyz="0 0 -0.05"/><mass value="0.2"/>
      <inertia ixx="0.0008" ixy="0" ixz="0" iyy="0.0008" iyz="0" izz="0.00005"/></inertial>
  </link>
  <joint name="knee" type="continuous"><origin xyz="0.01 0 -0.12"/>
    <parent link="thigh_plate"/><child link="shank"/><axis xyz="0 1 0"/>
    <limit effort="4" velocity="20"/></joint>
  <link name="toe"><collision><geometry><sphere radius="0.02"/></geometry></collision></link>
  <joint name="tip" type="fixed"><origin xyz="0 0 -0.13"/><parent link="shank"/><child link="toe"/></joint>
)";
const std::string kHopper = std::string(kHead) + kLeg + "</robot>";

MjcfOfUrdf made(const std::string& urdf, const std::string& file = "hopper.urdf") {
  return mjcf_of_urdf(urdf, file);
}

std::string fault(const std::string& urdf) {
  try {
    made(urdf);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadUrdf, IsToldByItsRoot) {
  EXPECT_TRUE(is_urdf(kHopper));
  EXPECT_TRUE(is_urdf("<robot/>"));
  for (const char* other : {"", "<", "<mujoco model=\"robot\"/>", "<!-- <robot> --><mujoco/>",
                            "<robots/>", "robot", "<!-- <robot>", "<?xml <robot>"})
    EXPECT_FALSE(is_urdf(other)) << other;
}

TEST(ReadUrdf, KeepsNamesPlacesMassesAndColours) {
  const MjcfOfUrdf hopper = made(kHopper);
  const ModelPointer model = compile_mjcf(hopper.text, "hopper.xml");
  const int trunk = mj_name2id(model.get(), mjOBJ_BODY, "trunk"),
            shank = mj_name2id(model.get(), mjOBJ_BODY, "shank"),
            toe = mj_name2id(model.get(), mjOBJ_BODY, "toe"),
            hip = mj_name2id(model.get(), mjOBJ_JOINT, "hip"),
            knee = mj_name2id(model.get(), mjOBJ_JOINT, "knee");
  ASSERT_TRUE(trunk > 0 && shank > 0 && toe > 0 && hip > 0 && knee > 0) << hopper.text;
  EXPECT_EQ(model->body_parentid[trunk], 0);
  EXPECT_EQ(model->jnt_type[model->body_jntadr[trunk]], mjJNT_FREE);
  EXPECT_EQ(model->body_mass[trunk], 2.0);
  EXPECT_EQ(model->body_mass[toe], 0.0);  // without <inertial>, though it has a shape
  EXPECT_EQ(vector_at(model->body_pos, shank), Eigen::Vector3d(0.01, 0, -0.12));
  EXPECT_EQ(model->dof_damping[model->jnt_dofadr[hip]], 0.1);
  EXPECT_EQ(model->dof_frictionloss[model->jnt_dofadr[hip]], 0.02);
  EXPECT_TRUE(model->jnt_limited[hip]);
  EXPECT_FALSE(model->jnt_limited[knee]);
  const int seen = model->body_geomadr[trunk];
  EXPECT_EQ(model->geom_contype[seen], 0);
  EXPECT_NEAR(model->geom_rgba[std::ptrdiff_t{4} * seen], 0.8, 1e-6);
  EXPECT_EQ(model->nu, 2);
  EXPECT_EQ(model->actuator_forcerange[1], 6.0);
  EXPECT_NEAR(model->actuator_gainprm[0], 6.0 / kFullTorqueError, 1e-9);
}

TEST(ReadUrdf, TellsWhatItMended) {
  const MjcfOfUrdf hopper = made(kHopper);
  ASSERT_EQ(hopper.notes.size(), 2u);
  EXPECT_TRUE(tells(hopper.notes[0], "'mount' has no mass and is left out")) << hopper.notes[0];
  EXPECT_TRUE(tells(hopper.notes[1], "2 joints get position servos")) << hopper.notes[1];
}

/// In the world's axes.
Eigen::Matrix3d inertia(const mjModel& model, const mjData& data, int body) {
  const Eigen::Matrix3d axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      data.ximat + std::ptrdiff_t{9} * body);
  return axes * vector_at(model.body_inertia, body).asDiagonal() * axes.transpose();
}

/// MuJoCo's own reader on the same text, at the same pose.
TEST(ReadUrdf, IsWhatMujocoReads) {
  for (const char* name : {"puppy", "crooked", "shifted_crooked"}) {
    const RobotModel robot = parse_robot(test::named_robot(name), name);
    const UrdfRobot urdf = urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "meshes/");
    char error[500] = "";
    const SpecPointer spec(mj_parseXMLString(urdf.text.c_str(), nullptr, error, sizeof error));
    ASSERT_TRUE(spec) << error;
    mjs_addFreeJoint(mjs_findBody(spec.get(), robot.root_body.c_str()));
    const ModelPointer theirs(mj_compile(spec.get(), nullptr));
    ASSERT_TRUE(theirs) << mjs_getError(spec.get());
    const ModelPointer ours = compile_mjcf(made(urdf.text).text, "robot.xml");
    ASSERT_EQ(ours->nbody, theirs->nbody) << name;
    ASSERT_EQ(ours->nq, theirs->nq) << name;
    const Eigen::VectorXd pose = Eigen::VectorXd::LinSpaced(ours->nq, -0.4, 0.7);
    const DataPointer a = kinematics_at(*ours, pose.data(), "a"),
                      b = kinematics_at(*theirs, pose.data(), "b");
    for (int body = 1; body < ours->nbody; ++body) {
      EXPECT_EQ(name_of(*ours, mjOBJ_BODY, body), name_of(*theirs, mjOBJ_BODY, body));
      EXPECT_NEAR(ours->body_mass[body], theirs->body_mass[body], 1e-12);
      EXPECT_LT((vector_at(a->xpos, body) - vector_at(b->xpos, body)).norm(), 1e-12) << name;
      EXPECT_LT((vector_at(a->xipos, body) - vector_at(b->xipos, body)).norm(), 1e-12) << name;
      EXPECT_LT((inertia(*ours, *a, body) - inertia(*theirs, *b, body)).norm(), 1e-12) << name;
    }
  }
}

TEST(ReadUrdf, ALinkIsAsLongAsToTheJointOrFootOnWhatIsFixedToIt) {
  const std::string text = made(kHopper).text;
  const std::string declared = test::with(
      text, "</mujoco>",
      "<custom><numeric name=\"legwright/a\" data=\"0.120415945788 0.1 0.2\"/>"
      "<text name=\"legwright/a\" data=\"m | stretch link: thigh | x\"/>"
      "<numeric name=\"legwright/b\" data=\"0.13 0.1 0.2\"/>"
      "<text name=\"legwright/b\" data=\"m | stretch link: shank | x\"/></custom></mujoco>");
  const RobotModel robot = parse_robot(declared, "hopper.xml");
  EXPECT_NEAR(robot.space.initial()[0], std::hypot(0.01, 0.12), 1e-9);
  EXPECT_EQ(robot.space.initial()[1], 0.13);
  const Eigen::Vector2d longer(0.17, 0.11);
  const ModelPointer model = compile_mjcf(rewrite_robot(robot, longer), "hopper.xml");
  const DataPointer data = kinematics_at(*model, nullptr, "hopper.xml");
  const auto at = [&](const char* body) -> Eigen::Vector3d {
    return vector_at(data->xpos, mj_name2id(model.get(), mjOBJ_BODY, body));
  };
  EXPECT_NEAR((at("shank") - at("thigh")).norm(), longer[0], 1e-9);
  EXPECT_NEAR((at("toe") - at("shank")).norm(), longer[1], 1e-9);
}

TEST(ReadUrdf, NoBodyHasMomentsThatMujocoRefuses) {
  const MjcfOfUrdf mended = made(test::with(kHopper, "ixx=\"0.001\"", "ixx=\"0.009\""));
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  const int thigh = mj_name2id(model.get(), mjOBJ_BODY, "thigh");
  EXPECT_NEAR(model->body_inertia[3 * thigh], (0.009 + 0.001 + 0.0001) / 3, 1e-12);
  EXPECT_TRUE(tells(mended.notes[1], "moments of inertia of thigh")) << mended.notes[1];
}

TEST(ReadUrdf, ALinkThatMovesWithoutMassGetsThatOfWhatIsFixedToIt) {
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
TEST(ReadUrdf, ALinkWithoutMassThatTurnsTheRobotIsItsTrunk) {
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

TEST(ReadUrdf, MimickedJointsAreCoupledAndGetNoServo) {
  const MjcfOfUrdf mended = made(
      test::with(kHopper, "<limit effort=\"4\" velocity=\"20\"/>",
                 "<limit effort=\"4\" velocity=\"20\"/><mimic joint=\"hip\" multiplier=\"-2\"/>"));
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  EXPECT_EQ(model->nu, 1);
  ASSERT_EQ(model->neq, 1);
  EXPECT_EQ(model->eq_data[1], -2.0);
}

TEST(ReadUrdf, FaultsHaveTheirPlace) {
  EXPECT_TRUE(tells(fault(test::with(kHopper, "value=\"2\"", "value=\"${mass}\"")),
                    "hopper.urdf:8: mass: holds a macro of xacro"))
      << fault(test::with(kHopper, "value=\"2\"", "value=\"${mass}\""));
  EXPECT_TRUE(tells(fault(test::with(kHopper, "<parent link=\"trunk\"/>", "")), "hopper.urdf"));
  EXPECT_TRUE(
      tells(fault(test::with(kHopper, "link=\"thigh_plate\"/><child", "link=\"none\"/><child")),
            "MuJoCo refuses it"));
  const std::string thigh = kHopper.substr(kHopper.find("<link name=\"thigh\">"));
  const std::string mass = thigh.substr(thigh.find("<inertial>"),
                                        thigh.find("</inertial>") + 11 - thigh.find("<inertial>"));
  EXPECT_TRUE(tells(fault(test::with(kHopper, mass, "")),
                    "hopper.urdf: link: thigh moves and neither it nor what is fixed there has an "
                    "<inertial>"))
      << fault(test::with(kHopper, mass, ""));
  EXPECT_TRUE(tells(fault("<robot name=\"x\"/>"), "robot 'x': has no <link>"));
  EXPECT_TRUE(tells(fault("<robot name=\"x\">"), "hopper.urdf:1"));
}

/// As the exporters of CAD programs leave them.
TEST(ReadUrdf, JointsWithoutEffortGetMotorsThatCarryTheRobot) {
  const std::string urdf = test::with(kHopper, "effort=\"6\"", "effort=\"0\"");
  const RobotModel robot = parse_robot(made(urdf).text, "hopper.urdf");
  const UrdfMending mending = mending_of(robot);
  const MjcfOfUrdf mended = mjcf_of_urdf(urdf, "hopper.urdf", mending);
  EXPECT_TRUE(tells(mended.notes[1], "hip has no <limit effort> above 0: the motor gets "))
      << mended.notes[1];
  const ModelPointer model = compile_mjcf(mended.text, "hopper.urdf");
  const int hip = mj_name2id(model.get(), mjOBJ_ACTUATOR, "hip");
  ASSERT_GE(hip, 0);
  EXPECT_NEAR(model->actuator_forcerange[2 * hip + 1], mending.most_torque, 1e-9);
}

TEST(ReadUrdf, NamesWithBlanksAreRenamedEachToItsOwn) {
  std::string urdf = test::with(kHopper, "joint name=\"hip\"", "joint name=\"Revolute 1\"");
  urdf = test::with(urdf, "joint name=\"knee\"", "joint name=\"Revolute_1\"");
  const MjcfOfUrdf renamed = made(urdf);
  const RobotModel robot = parse_robot(renamed.text, "hopper.urdf");
  ASSERT_EQ(robot.morphology.joint_count(), 2);
  EXPECT_EQ(robot.morphology.links[1].joint.name, "Revolute_1_2");
  EXPECT_EQ(robot.morphology.links[2].joint.name, "Revolute_1") << "which needs no change";
  EXPECT_TRUE(tells(renamed.notes.back(), "like 'Revolute 1' as 'Revolute_1_2'"))
      << renamed.notes.back();
}

TEST(ReadUrdf, RangesOfNothingAreTold) {
  const std::string urdf =
      test::with(kHopper, "<limit effort=\"4\" velocity=\"20\"/>",
                 "<limit lower=\"0\" upper=\"0\" effort=\"4\" velocity=\"20\"/>");
  std::string all;
  for (const std::string& note : made(test::with(urdf, "continuous", "revolute")).notes)
    all += note;
  EXPECT_TRUE(tells(all, "<limit> has no range for knee, where upper is not above lower")) << all;
}

TEST(ReadUrdf, APackageWithoutNameIsTheFolderOfTheFile) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "body.stl") << "solid";
  const UrdfMeshFile found = find_urdf_mesh("package://body.stl", folder.path(), "");
  EXPECT_EQ(found.kind, UrdfMeshKind::found);
  EXPECT_EQ(found.path, "body.stl");
}

TEST(ReadUrdf, PlaceholdersGiveNoGainsAndOverlappingShapesMayPass) {
  std::string urdf = test::with(kHopper, "effort=\"6\"", "effort=\"1000\"");
  const std::string shape =
      "<collision><geometry><box size=\"0.02 0.02 0.3\"/></geometry></collision>";
  urdf = test::with(urdf, "<link name=\"shank\">", "<link name=\"shank\">" + shape);
  const RobotModel robot = parse_robot(made(urdf).text, "hopper.urdf");
  const UrdfMending mending = mending_of(robot);
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

class UrdfMeshes : public testing::Test {
 protected:
  void add(const std::string& name) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
  }
  UrdfMeshFile find(const std::string& name, const std::string& mesh_folder = "") const {
    return find_urdf_mesh(name, folder_.path() / "dog_description" / "urdf", mesh_folder);
  }
  void SetUp() override { fs::create_directories(folder_.path() / "dog_description" / "urdf"); }
  const test::TemporaryFolder folder_;
};

TEST_F(UrdfMeshes, OfPackagesAreLookedForAboveTheUrdf) {
  add("dog_description/meshes/hip.stl");
  add("other/meshes/arm.STL");
  EXPECT_EQ(find("package://dog_description/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("package://renamed/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("package://other/meshes/arm.STL").path, "../../other/meshes/arm.STL");
  EXPECT_EQ(find("../meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("hip.stl", "../meshes").path, "../meshes/hip.stl");
  EXPECT_EQ(find("file://" + (folder_.path() / "other/meshes/arm.STL").string()).kind,
            UrdfMeshKind::found);
  EXPECT_EQ(find("package://dog_description/meshes/knee.stl").kind, UrdfMeshKind::missing);
}

TEST_F(UrdfMeshes, OfOtherFormatsHaveATwinOrNone) {
  add("dog_description/meshes/hip.dae");
  EXPECT_EQ(find("package://dog_description/meshes/hip.dae").kind, UrdfMeshKind::unreadable);
  add("dog_description/meshes/hip.obj");
  const UrdfMeshFile found = find("package://dog_description/meshes/hip.dae");
  EXPECT_EQ(found.kind, UrdfMeshKind::other_format);
  EXPECT_EQ(found.path, "../meshes/hip.obj");
}

}  // namespace
}  // namespace legwright
