// SPDX-License-Identifier: Apache-2.0
// Robots of other construction: what rides along, what is coupled, and three whole robots.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "mjcf/read/couplings.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "mjcf/write/verify.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/mesh_quadruped.hpp"
#include "tests/mjcf/robots/point_mass_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

using test::error_message;
using test::holds;

std::string constructed_robot(const std::string& name) {
  if (name == "armed_biped") return test::armed_biped();
  return test::declared(name == "classed_quadruped" ? test::classed_quadruped()
                                                    : test::quadruped_with_arm());
}

VectorXd home_of(const mjModel& model) {
  const int home = mj_name2id(&model, mjOBJ_KEY, "home");
  return VectorXd::Map(model.key_qpos + home * model.nq, model.nq);
}

/// qpos of the full model with the legs somewhere and what rides held, and the same for the plan.
struct Pose {
  VectorXd qpos, qvel, played_qpos, played_qvel;
};
Pose random_pose(const RobotModel& robot, const mjModel& model, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  const int joints = robot.morphology.joint_count();
  Pose pose{home_of(model), VectorXd::Zero(model.nv), VectorXd(7 + joints), VectorXd(6 + joints)};
  for (double& x : pose.played_qpos) x = uniform(random);
  for (double& x : pose.played_qvel) x = uniform(random);
  pose.played_qpos.segment<4>(3).normalize();
  pose.qpos.head<7>() = pose.played_qpos.head<7>();
  pose.qvel.head<6>() = pose.played_qvel.head<6>();
  for (int a = 0; a < joints; ++a) {
    const std::string& name = robot.morphology.links[static_cast<std::size_t>(a) + 1].joint.name;
    const int j = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
    pose.qpos[model.jnt_qposadr[j]] = pose.played_qpos[7 + a];
    pose.qvel[model.jnt_dofadr[j]] = pose.played_qvel[6 + a];
  }
  return pose;
}

/// Feet are points here, not the middles of geoms.
double difference_but_feet(test::RobotState a, test::RobotState b) {
  a.feet.clear();
  b.feet.clear();
  return test::difference(a, b);
}

class Construction : public testing::TestWithParam<const char*> {};

TEST_P(Construction, EachDesignIsTheIntendedOneInMujoco) {
  const std::string xml = constructed_robot(GetParam());
  const RobotModel robot = parse_robot(xml, "robot.xml");
  ASSERT_GT(robot.space.size(), 3);
  EXPECT_TRUE(rewrite_robot(robot, robot.space.initial()) == xml);
  std::mt19937 random(3);
  for (int trial = 0; trial < 30; ++trial) {
    const VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);
    const ModelPointer model = compile_mjcf(text, "design.xml");
    const Pose pose = random_pose(robot, *model, random);
    const test::RobotState planned =
        test::state_of(robot.morphology, s, pose.played_qpos, pose.played_qvel);
    Morphology no_feet = robot.morphology;
    no_feet.feet.clear();
    ASSERT_LT(
        difference_but_feet(test::MujocoRobot(text).state(no_feet, pose.qpos, pose.qvel), planned),
        1e-9)
        << "trial " << trial;
    // As it is played: the same robot without what is held, feet by name.
    const std::string played = played_robot(robot, text);
    const test::MujocoRobot engine(played);
    ASSERT_EQ(engine.nq(), 7 + robot.morphology.joint_count());
    ASSERT_LT(difference_but_feet(
                  engine.state(robot.morphology, pose.played_qpos, pose.played_qvel), planned),
              1e-9);
  }
  const VectorXd s = robot.space.initial();
  std::string text = played_robot(robot, xml);
  for (std::size_t at; (at = text.find("\"foot:")) != std::string::npos;)
    text.replace(at, 6, "\"mark ");  // names that only scenes may use
  const RobotModel played = parse_robot(text, "played.xml");
  EXPECT_EQ(find_difference(robot.morphology, s, played.morphology, s), "");
}

class WithRiders : public testing::TestWithParam<const char*> {};

TEST_P(WithRiders, WeighWhereTheyAreHeld) {
  const RobotModel robot = parse_robot(constructed_robot(GetParam()), "robot.xml");
  const ModelPointer model = compile_mjcf(robot.xml, "robot.xml");
  std::mt19937 random(4);
  Pose pose = random_pose(robot, *model, random);
  Morphology no_feet = robot.morphology;
  no_feet.feet.clear();
  const auto error = [&] {
    return difference_but_feet(test::MujocoRobot(robot.xml).state(no_feet, pose.qpos, pose.qvel),
                               test::state_of(robot.morphology, robot.space.initial(),
                                              pose.played_qpos, pose.played_qvel));
  };
  EXPECT_LT(error(), 1e-9);
  pose.qpos[model->jnt_qposadr[robot.structure.frozen.front().joint]] += 0.5;
  EXPECT_GT(error(), 1e-4);  // elsewhere than at home
  EXPECT_NEAR(robot.morphology.total_mass(), model->body_subtreemass[0], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Robots, Construction,
                         testing::Values("armed_biped", "classed_quadruped", "quadruped_with_arm"));
INSTANTIATE_TEST_SUITE_P(Robots, WithRiders, testing::Values("armed_biped", "quadruped_with_arm"));

TEST(Riding, ArmAndLidarAreHeldAndDistinguishedFromLegs) {
  const RobotModel robot = parse_robot(test::armed_biped(), "robot.xml");
  EXPECT_EQ(robot.morphology.joint_count(), 8);
  ASSERT_EQ(robot.structure.frozen.size(), 5u);  // shoulder, ball, thumb, finger, lidar
  EXPECT_EQ(robot.structure.frozen[0].name, "shoulder");
  EXPECT_EQ(robot.structure.frozen[1].body, "hand");
  EXPECT_EQ(robot.structure.frozen[4].body, "lidar");
  for (const FrozenJoint& frozen : robot.structure.frozen) EXPECT_EQ(frozen.why, "rides along");
  ASSERT_EQ(robot.morphology.feet.size(), 2u);
  EXPECT_EQ(robot.morphology.feet[0].name, "left_foot");  // after the link
  EXPECT_EQ(robot.servos.size(), 8u);
  EXPECT_EQ(robot.servos[4].actuator, "right_roll");
}

TEST(Riding, ALegThatIsLiftedAtHomeRides) {
  const std::string xml = test::quadruped_with_arm();
  EXPECT_EQ(parse_robot(xml, "robot.xml").morphology.foot_count(), 4);
  EXPECT_EQ(parse_robot(test::with(xml, "1 0 0 0 0 1.04 -1.8", "1 0 0 0 0 2.2 -2.7"), "robot.xml")
                .morphology.foot_count(),
            3);
}

TEST(Riding, IsReportedToPeople) {
  EXPECT_EQ(
      held_text(parse_robot(test::armed_biped(), "robot.xml").structure),
      "  rides along, held in the home pose: shoulder, a joint of hand, thumb, finger, a joint "
      "of lidar\n");
  EXPECT_EQ(held_text(parse_robot(test::classed_quadruped(), "robot.xml").structure), "");
}

/// A leg that the home pose lifts is none, but it is told that it is built as one: a sign may be
/// wrong.
TEST(Riding, ALegInTheAirIsDistinguishedFromAnArm) {
  const RobotModel stands = parse_robot(test::mesh_quadruped(), "robot.xml");
  EXPECT_EQ(stands.morphology.foot_count(), 4);
  EXPECT_TRUE(stands.structure.frozen.empty());
  const RobotModel lifts =
      parse_robot(test::with(test::mesh_quadruped(), "1 0 0 0  0 0.8 -2.1", "1 0 0 0  0 2.9 -0.3"),
                  "robot.xml");
  EXPECT_EQ(lifts.morphology.foot_count(), 3);
  EXPECT_TRUE(holds(held_text(lifts.structure), "built as a leg is but up in the air"));
  EXPECT_TRUE(holds(held_text(lifts.structure), "fl_hx, fl_hy, fl_kn"));
}

TEST(Riding, TheHomePoseIsTheOnlyKeyframeWhateverItsName) {
  const std::string other = test::with(test::classed_quadruped(), "\"home\"", "\"standing\"");
  EXPECT_EQ(parse_robot(other, "robot.xml").morphology.links[2].joint.nominal, 0.9);
  const std::string two = test::with(other, "<keyframe>", "<keyframe><key name=\"lying\"/>");
  EXPECT_TRUE(holds(error_message(two), "outside of its range"));  // then it is the file's own pose
}

TEST(Riding, DesignsDoNotReachWhatRides) {
  const std::string xml = test::armed_biped();
  const std::string axis = "| axis z: left_knee ~right_knee |";
  EXPECT_TRUE(holds(error_message(test::with(xml, axis, "| axis z: shoulder |")),
                    "held in its home pose (rides along)"));
  EXPECT_TRUE(holds(error_message(test::with(xml, "| stretch y: pelvis |", "| stretch y: arm |")),
                    "not spread along y"));
}

TEST(Riding, PlayedRobotHasNothingThatReferred) {
  const RobotModel robot = parse_robot(test::armed_biped(), "robot.xml");
  const ModelPointer model = compile_mjcf(played_robot(robot, robot.xml), "played.xml");
  EXPECT_EQ(model->njnt, 9);
  EXPECT_EQ(model->neq, 0);
  EXPECT_EQ(model->ntendon, 0);
  EXPECT_EQ(model->nsensor, 1);
  EXPECT_EQ(model->nu, 8);
  EXPECT_EQ(model->key_qpos[7 + 7], -0.3);  // of the right ankle: what was behind it is gone
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_GEOM, "left_foot"), 0);
  EXPECT_EQ(compile_mjcf(robot.xml, "robot.xml")->nsensor, 4);
  const RobotModel puppy = read_robot(test::puppy_file());
  EXPECT_TRUE(played_robot(puppy, puppy.xml) == puppy.xml);  // nothing to do, nothing done
}

std::string coupled(const std::string& extra) {
  // A toe below the shank, which touches the ground.
  const std::string xml = test::hopper_with(
      "<body name=\"toe\" pos=\"0 0 -0.2\"><joint name=\"toe\" axis=\"0 1 0\"/>"
      "<inertial pos=\"0 0 0\" mass=\"0.05\" diaginertia=\"1e-5 1e-5 1e-5\"/>"
      "<geom name=\"tip\" size=\"0.02\" pos=\"0.01 0 -0.03\"/></body>",
      -0.4);
  return test::with(test::with(xml, "0 -0.4\"/></keyframe>", "0.2 -0.4 0.3\"/></keyframe>"),
                    "<actuator>", extra + "<actuator>");
}

TEST(Couplings, ACoupledJointOfALegIsHeld) {
  EXPECT_TRUE(
      holds(error_message(coupled("")), "joint 'toe': has no actuator"));  // negative control
  for (const char* extra :
       {"<equality><joint name=\"linkage\" joint1=\"toe\"/></equality>",
        "<tendon><fixed name=\"linkage\" stiffness=\"10\"><joint joint=\"toe\" coef=\"1\"/></fixed>"
        "</tendon>"}) {
    const RobotModel robot = parse_robot(coupled(extra), "robot.xml");
    EXPECT_EQ(robot.morphology.joint_count(), 2);
    ASSERT_EQ(robot.structure.frozen.size(), 1u);
    EXPECT_EQ(robot.structure.frozen[0].name, "toe");
    EXPECT_TRUE(holds(robot.structure.frozen[0].why, "coupled by"))
        << robot.structure.frozen[0].why;
    EXPECT_TRUE(holds(robot.structure.frozen[0].why, "'linkage'"));
    EXPECT_EQ(robot.morphology.feet[0].name, "tip");
    // The toe is bent by 0.3 rad in the shank's frame.
    const Vector3d tip =
        Vector3d(0, 0, -0.2) + Eigen::AngleAxisd(0.3, Vector3d::UnitY()) * Vector3d(0.01, 0, -0.03);
    EXPECT_LT((robot.morphology.feet[0].position.at(VectorXd()) - tip).norm(), 1e-12);
  }
}

/// What bends a tendon is between its bodies, in a time that grows with their number alone.
TEST(Couplings, ATendonOverManySitesIsReadAtOnce) {
  const auto rope = [](int turns, const char* one, const char* other) {
    std::string sites;
    for (int k = 0; k < turns; ++k)
      sites += fmt::format("<site site=\"{}\"/><site site=\"{}\"/>", one, other);
    std::string xml = test::hopper_with(
        "<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/><site name=\"low\" pos=\"0 0.01 "
        "-0.1\"/>");
    xml = test::with(xml, "<body name=\"shank\"",
                     "<site name=\"mid\" pos=\"0 0.01 -0.1\"/><body name=\"shank\"");
    xml = test::with(xml, "<body name=\"thigh\">", "<site name=\"top\"/><body name=\"thigh\">");
    return compile_mjcf(
        test::with(xml, "<actuator>",
                   "<tendon><spatial name=\"rope\">" + sites + "</spatial></tendon><actuator>"),
        "rope.xml");
  };
  const auto between = [&](const char* one, const char* other) {
    std::string names;
    const ModelPointer model = rope(1, one, other);
    for (const int joint : joints_under(*model, 0)) names += name_of(*model, mjOBJ_JOINT, joint);
    return names;
  };
  EXPECT_EQ(between("top", "low"), "hipknee");
  EXPECT_EQ(between("mid", "low"), "knee");
  EXPECT_EQ(between("top", "mid"), "hip");
  const ModelPointer model = rope(9000, "top", "low");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(joints_under(*model, 0).size(), 2u);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 1.0);
}

TEST(Couplings, AHeldHingeBehindAMovingOneLeavesItsLineWhereItIs) {
  std::string xml = test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>");
  xml = test::with(xml, "<joint name=\"hip\" axis=\"0 1 0\"/>",
                   "<joint name=\"hip\" axis=\"0 1 0\" pos=\"0.01 0.02 0\"/>"
                   "<joint name=\"roll\" axis=\"1 0 0\"/>");
  xml = test::with(xml, "0 0 0 0 ", "0 0 0 0 0.3 ");
  xml = test::with(xml, "<actuator>",
                   "<equality><joint name=\"linkage\" joint1=\"roll\"/></equality><actuator>");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  ASSERT_EQ(robot.morphology.joint_count(), 2);
  const ModelPointer whole = compile_mjcf(xml, "whole.xml");
  const ModelPointer played = compile_mjcf(played_robot(robot, xml), "played.xml");
  ASSERT_EQ(whole->nq, 10);
  ASSERT_EQ(played->nq, 9);
  const double at_whole[] = {0, 0, 0.5, 1, 0, 0, 0, 0.5, 0.3, -0.7};
  const double at_played[] = {0, 0, 0.5, 1, 0, 0, 0, 0.5, -0.7};
  const DataPointer a = kinematics_at(*whole, at_whole, "whole.xml");
  const DataPointer b = kinematics_at(*played, at_played, "played.xml");
  for (const char* body : {"thigh", "shank"}) {
    const int in_a = mj_name2id(whole.get(), mjOBJ_BODY, body),
              in_b = mj_name2id(played.get(), mjOBJ_BODY, body);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a->xpos[3 * in_a + k], b->xpos[3 * in_b + k], 1e-12);
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(a->xmat[9 * in_a + k], b->xmat[9 * in_b + k], 1e-12);
  }
}

TEST(Couplings, ATendonThatOnlyMeasuresHoldsNothing) {
  const std::string measures =
      "<tendon><fixed name=\"sum\"><joint joint=\"hip\" coef=\"1\"/>"
      "<joint joint=\"knee\" coef=\"1\"/></fixed></tendon>";
  const std::string xml =
      test::with(test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>"),
                 "<actuator>", measures + "<actuator>");
  EXPECT_TRUE(parse_robot(xml, "robot.xml").structure.frozen.empty());
  EXPECT_TRUE(holds(error_message(test::with(xml, "name=\"sum\"", "name=\"sum\" range=\"0 1\"")),
                    "no joint moves by itself"));
}

TEST(Couplings, LoopsAmongWhatIsHeldAreNone) {
  const std::string arm = test::armed_biped();
  const std::string tied = test::with(
      arm, "<equality>", "<equality><connect body1=\"hand\" body2=\"pelvis\" anchor=\"0 0 0\"/>");
  EXPECT_EQ(error_message(tied), "");
  EXPECT_TRUE(holds(error_message(test::with(tied, "body2=\"pelvis\"", "body2=\"left_shank\"")),
                    "parallel linkages are not supported"));
  EXPECT_TRUE(holds(error_message(test::with(tied, " body2=\"pelvis\"", "")), "in the world"));
}

TEST(Construction, AllJointsWithoutActuatorAreToldAtOnce) {
  std::string xml = test::named_robot("puppy");
  const std::size_t from = xml.find("<actuator>"), to = xml.find("</actuator>");
  ASSERT_LT(from, to);
  xml.erase(from, to - from + std::string("</actuator>").size());
  const std::size_t ctrl = xml.find("ctrl=\"");
  ASSERT_NE(ctrl, std::string::npos);
  xml.erase(ctrl, xml.find('"', ctrl + 6) + 1 - ctrl);
  const std::string told = error_message(xml);
  for (const char* joint : {"FL_hip", "FL_knee", "HR_ankle"})
    EXPECT_TRUE(holds(told, fmt::format("joint '{}': has no actuator", joint))) << told;
}

}  // namespace
}  // namespace legwright
