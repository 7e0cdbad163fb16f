// SPDX-License-Identifier: Apache-2.0
// The MJCF that is made of a URDF is the robot that MuJoCo itself reads from it, but for what is
// said to be mended.
#include "mjcf/urdf/read_urdf.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/urdf/write_urdf.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/urdf/hopper.hpp"
#include "tests/support/source_tree.hpp"

namespace legwright {
namespace {

using test::kHopper;
using test::made;
using test::tells;

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
  EXPECT_EQ(model->geom_group[seen + 1], 3) << "its shape for collisions is not drawn over it";
  EXPECT_EQ(model->geom_group[model->body_geomadr[toe]], 0) << "that of a toe without pictures is";
  EXPECT_NEAR(model->geom_rgba[std::ptrdiff_t{4} * seen], 0.8, 1e-6);
  EXPECT_EQ(model->nu, 2);
  EXPECT_EQ(model->actuator_forcerange[1], 6.0);
  EXPECT_NEAR(model->actuator_gainprm[0], 6.0 / kFullTorqueError, 1e-9);
}

TEST(ReadUrdf, TellsWhatItMended) {
  const MjcfOfUrdf hopper = made(kHopper);
  ASSERT_EQ(hopper.notes.size(), 4u);
  EXPECT_TRUE(tells(hopper.notes[0], "'mount' has no mass and is left out")) << hopper.notes[0];
  EXPECT_TRUE(tells(hopper.notes[1], "2 joints get position servos")) << hopper.notes[1];
  EXPECT_TRUE(tells(hopper.notes[2], "reflected inertia of geared ones")) << hopper.notes[2];
  EXPECT_TRUE(tells(hopper.notes[3], "2 motors keep their <limit velocity>, 20 rad/s"))
      << hopper.notes[3];
}

/// Exporters write shapes of size zero, which MuJoCo refuses: for points of contact, for nothing.
TEST(ReadUrdf, ShapesOfSizeZeroAreBallsOrLeftOut) {
  std::string urdf = test::with(kHopper, "<sphere radius=\"0.02\"/>", "<sphere radius=\"0.0\"/>");
  urdf = test::with(urdf, "<visual><geometry><box size=\"0.2 0.1 0.04\"/>",
                    "<visual><geometry><box size=\"0 0 0\"/>");
  urdf = test::with(urdf, "<link name=\"thigh_plate\"/>",
                    "<link name=\"thigh_plate\"><collision><geometry>"
                    "<cylinder radius=\"0.1\" length=\"0\"/></geometry></collision></link>");
  const MjcfOfUrdf hopper = made(urdf);
  const ModelPointer model = compile_mjcf(hopper.text, "hopper.xml");
  ASSERT_EQ(model->ngeom, 2) << hopper.text;
  const int toe = mj_name2id(model.get(), mjOBJ_BODY, "toe");
  EXPECT_EQ(model->geom_size[std::ptrdiff_t{3} * model->body_geomadr[toe]], 0.001);
  const std::string told = test::joined(hopper.notes);
  EXPECT_TRUE(tells(told, "are balls of a millimetre: of toe")) << told;
  EXPECT_TRUE(tells(told, "as their size is zero: shapes of trunk, thigh_plate")) << told;
}

TEST(ReadUrdf, SpeedLimitsAreThoseOfMotorsAndComeBack) {
  const std::string urdf =
      test::with(kHopper, "effort=\"6\" velocity=\"20\"", "effort=\"6\" velocity=\"1.5\"");
  const MjcfOfUrdf hopper = made(urdf);
  const RobotModel robot = parse_robot(hopper.text, "hopper.xml");
  const Joint &hip = robot.morphology.links[1].joint, &knee = robot.morphology.links[2].joint;
  ASSERT_TRUE(hip.line && knee.line) << hopper.text;
  EXPECT_EQ(hip.line->no_load_speed, 1.5);
  EXPECT_EQ(hip.line->stall_torque, 12.0) << "its effort is there up to half of that speed";
  EXPECT_EQ(hip.torque_limit, 6.0);
  EXPECT_EQ(knee.line->no_load_speed, 20.0);
  EXPECT_TRUE(tells(hopper.notes.back(), "1.5 to 20 rad/s")) << hopper.notes.back();
  const UrdfRobot back = urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "meshes/");
  EXPECT_TRUE(tells(back.text, "effort=\"6\" velocity=\"1.5\"")) << back.text;
  EXPECT_TRUE(tells(back.text, "effort=\"4\" velocity=\"20\"")) << back.text;
}

TEST(ReadUrdf, SpeedsThatStandForNoneAreNone) {
  for (const char* none : {" velocity=\"0\"", " velocity=\"1000\"", ""}) {
    const std::string limit = "effort=\"6\" velocity=\"20\"";
    const MjcfOfUrdf hopper = made(test::with(kHopper, limit, std::string("effort=\"6\"") + none));
    const RobotModel robot = parse_robot(hopper.text, "hopper.xml");
    EXPECT_FALSE(robot.morphology.links[1].joint.line) << none;
    EXPECT_TRUE(robot.morphology.links[2].joint.line) << none;
    const UrdfRobot back = urdf_of(robot, *compile_mjcf(robot.xml, robot.file), "meshes/");
    EXPECT_TRUE(tells(back.text, "effort=\"6\" velocity=\"1000\"")) << back.text;
  }
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

TEST(ReadUrdf, MimickedJointsAreCoupledAndGetNoServo) {
  const MjcfOfUrdf mended = made(
      test::with(kHopper, "<limit effort=\"4\" velocity=\"20\"/>",
                 "<limit effort=\"4\" velocity=\"20\"/><mimic joint=\"hip\" multiplier=\"-2\"/>"));
  const ModelPointer model = compile_mjcf(mended.text, "hopper.xml");
  EXPECT_EQ(model->nu, 1);
  ASSERT_EQ(model->neq, 1);
  EXPECT_EQ(model->eq_data[1], -2.0);
}

TEST(ReadUrdf, PackagesOfMeshesNeedNoXacroOtherMacrosDo) {
  const auto with_mesh = [](const std::string& name) {
    return test::with(
        kHopper, "<visual>",
        "<visual><geometry><mesh filename=\"" + name + "\"/></geometry></visual><visual>");
  };
  for (const char* name : {"file://$(find dog)/hip.stl", "$(find dog)\\hip.stl"})
    EXPECT_TRUE(compile_mjcf(made(with_mesh(name)).text, "hopper.xml")) << name;
  for (const char* name : {"$(find dog)/${side}.stl", "$(arg folder)/hip.stl", "$(find dog"})
    EXPECT_TRUE(tells(fault(with_mesh(name)), "mesh: holds a macro of xacro")) << name;
}

TEST(ReadUrdf, FaultsHaveTheirPlace) {
  EXPECT_TRUE(tells(fault(test::with(kHopper, "value=\"2\"", "value=\"${mass}\"")),
                    "hopper.urdf:8: mass: holds a macro of xacro"))
      << fault(test::with(kHopper, "value=\"2\"", "value=\"${mass}\""));
  EXPECT_TRUE(tells(fault(test::with(kHopper, "<parent link=\"trunk\"/>", "")), "hopper.urdf"));
  const std::string thigh = kHopper.substr(kHopper.find("<link name=\"thigh\">"));
  const std::string mass = thigh.substr(thigh.find("<inertial>"),
                                        thigh.find("</inertial>") + 11 - thigh.find("<inertial>"));
  EXPECT_TRUE(tells(fault(test::with(kHopper, mass, "")),
                    "hopper.urdf: link: thigh moves and neither it nor what is fixed there has an "
                    "<inertial> with a mass above 0"))
      << fault(test::with(kHopper, mass, ""));
  EXPECT_TRUE(tells(fault("<robot name=\"x\"/>"), "robot 'x': has no <link>"));
  EXPECT_TRUE(tells(fault("<robot name=\"x\">"), "hopper.urdf:1"));
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

/// As Unitree's exporter does.
TEST(ReadUrdf, AMaterialThatIsWrittenTwiceCountsOnce) {
  const std::string urdf = test::with(kHopper, "<material name=\"red\"/></visual>",
                                      "<material name=\"red\"/><material name=\"blue\"/></visual>");
  const MjcfOfUrdf found = made(urdf);
  const ModelPointer model = compile_mjcf(found.text, "hopper.xml");
  EXPECT_NEAR(model->geom_rgba[0], 0.8, 1e-6);
  EXPECT_TRUE(tells(found.notes[0], "several <material>")) << found.notes[0];
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

}  // namespace
}  // namespace legwright
