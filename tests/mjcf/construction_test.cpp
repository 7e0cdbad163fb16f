// SPDX-License-Identifier: Apache-2.0
// Robots of other construction: parts that ride along, couplings, feet of any shape, frames and
// meshes in stretched bodies.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mjcf/compile.hpp"
#include "mjcf/input_error.hpp"
#include "mjcf/played_robot.hpp"
#include "mjcf/proposals.hpp"
#include "mjcf/rewrite_robot.hpp"
#include "mjcf/verify.hpp"
#include "tests/mjcf/construction_robots.hpp"
#include "tests/mjcf/point_mass_robot.hpp"
#include "tests/mjcf/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::string complaint(const std::string& xml) {
  try {
    parse_robot(xml, "robot.xml");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// With the parameters that `legwright init` proposes.
std::string declared(const std::string& xml) {
  return with_declarations(xml, "robot.xml", study_robot(xml, "robot.xml").proposals);
}

std::string named(const std::string& name) {
  if (name == "armed_biped") return test::armed_biped();
  return declared(name == "classed_quadruped" ? test::classed_quadruped()
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
  const std::string xml = named(GetParam());
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
    ASSERT_LT(difference_but_feet(test::MujocoRobot(text).state(no_feet, pose.qpos, pose.qvel),
                                  planned),
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
  const RobotModel played = parse_robot(played_robot(robot, xml), "played.xml");
  EXPECT_EQ(find_difference(robot.morphology, s, played.morphology, s), "");
}

class WithRiders : public testing::TestWithParam<const char*> {};

TEST_P(WithRiders, WeighWhereTheyAreHeld) {
  const RobotModel robot = parse_robot(named(GetParam()), "robot.xml");
  const ModelPointer model = compile_mjcf(robot.xml, "robot.xml");
  std::mt19937 random(4);
  Pose pose = random_pose(robot, *model, random);
  Morphology no_feet = robot.morphology;
  no_feet.feet.clear();
  const auto error = [&] {
    return difference_but_feet(
        test::MujocoRobot(robot.xml).state(no_feet, pose.qpos, pose.qvel),
        test::state_of(robot.morphology, robot.space.initial(), pose.played_qpos,
                       pose.played_qvel));
  };
  EXPECT_LT(error(), 1e-9);
  pose.qpos[model->jnt_qposadr[robot.structure.frozen.front().joint]] += 0.5;
  EXPECT_GT(error(), 1e-4);  // elsewhere than at home
  EXPECT_NEAR(robot.morphology.total_mass(), model->body_subtreemass[0], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Robots, Construction,
                         testing::Values("armed_biped", "classed_quadruped", "quadruped_with_arm"));
INSTANTIATE_TEST_SUITE_P(Robots, WithRiders,
                         testing::Values("armed_biped", "quadruped_with_arm"));

TEST(Riding, ArmAndLidarAreHeldAndToldApartFromLegs) {
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

TEST(Riding, DesignsDoNotReachWhatRides) {
  const std::string xml = test::armed_biped();
  const std::string axis = "| axis z: left_knee ~right_knee |";
  EXPECT_TRUE(holds(complaint(test::with(xml, axis, "| axis z: shoulder |")),
                    "held in its home pose (rides along)"));
  EXPECT_TRUE(holds(complaint(test::with(xml, "| stretch y: pelvis |", "| stretch y: arm |")),
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

// ------------------------------------------------------------------------------------- couplings

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
  EXPECT_TRUE(holds(complaint(coupled("")), "joint 'toe': has no actuator"));  // negative control
  for (const char* extra :
       {"<equality><joint name=\"linkage\" joint1=\"toe\"/></equality>",
        "<tendon><fixed name=\"linkage\" stiffness=\"10\"><joint joint=\"toe\" coef=\"1\"/></fixed>"
        "</tendon>"}) {
    const RobotModel robot = parse_robot(coupled(extra), "robot.xml");
    EXPECT_EQ(robot.morphology.joint_count(), 2);
    ASSERT_EQ(robot.structure.frozen.size(), 1u);
    EXPECT_EQ(robot.structure.frozen[0].name, "toe");
    EXPECT_TRUE(holds(robot.structure.frozen[0].why, "coupled by")) << robot.structure.frozen[0].why;
    EXPECT_TRUE(holds(robot.structure.frozen[0].why, "'linkage'"));
    EXPECT_EQ(robot.morphology.feet[0].name, "tip");
    // The toe is bent by 0.3 rad in the shank's frame.
    const Vector3d tip = Vector3d(0, 0, -0.2) + Eigen::AngleAxisd(0.3, Vector3d::UnitY()) *
                                                    Vector3d(0.01, 0, -0.03);
    EXPECT_LT((robot.morphology.feet[0].position.at(VectorXd()) - tip).norm(), 1e-12);
  }
}

TEST(Couplings, ATendonThatOnlyMeasuresHoldsNothing) {
  const std::string measures =
      "<tendon><fixed name=\"sum\"><joint joint=\"hip\" coef=\"1\"/>"
      "<joint joint=\"knee\" coef=\"1\"/></fixed></tendon>";
  const std::string xml = test::with(
      test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>"), "<actuator>",
      measures + "<actuator>");
  EXPECT_TRUE(parse_robot(xml, "robot.xml").structure.frozen.empty());
  EXPECT_TRUE(holds(complaint(test::with(xml, "name=\"sum\"", "name=\"sum\" range=\"0 1\"")),
                    "no joint moves by itself"));
}

TEST(Couplings, LoopsAmongWhatIsHeldAreNone) {
  const std::string arm = test::armed_biped();
  const std::string tied = test::with(
      arm, "<equality>", "<equality><connect body1=\"hand\" body2=\"pelvis\" anchor=\"0 0 0\"/>");
  EXPECT_EQ(complaint(tied), "");
  EXPECT_TRUE(holds(complaint(test::with(tied, "body2=\"pelvis\"", "body2=\"left_shank\"")),
                    "close loops"));
  EXPECT_TRUE(holds(complaint(test::with(tied, " body2=\"pelvis\"", "")), "in the world"));
}

TEST(Refusals, AllReasonsAreToldAtOnceEachWithItsLine) {
  std::string xml = test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>");
  xml = test::with(xml, "<joint name=\"knee\" axis=\"0 1 0\"/>",
                   "<joint name=\"knee\" axis=\"0 1 0\" type=\"slide\"/>");
  xml = test::with(xml, "<body name=\"thigh\">", "<body name=\"thigh\" gravcomp=\"1\">");
  xml = test::with(xml, "  </worldbody>",
                   "    <body name=\"ball\"><freejoint/><geom size=\"0.1\"/></body>\n"
                   "  </worldbody>");
  xml = test::with(xml, "  <keyframe><key name=\"home\" qpos=\"0 0 0.5 1 0 0 0 0 0\"/></keyframe>",
                   "  <equality><weld name=\"w\" body1=\"shank\" body2=\"trunk\"/></equality>");
  const std::string all = complaint(xml);
  for (const char* part :
       {"robot.xml:11: body 'thigh': attribute gravcomp", "joint 'knee': slide joints",
        "body 'ball': a second free root", "weld 'w': equality constraints close loops"})
    EXPECT_TRUE(holds(all, part)) << part << " not in:\n" << all;
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 3) << all;
}

// ------------------------------------------------------------------------------------------ feet

struct FootCase {
  const char* text;
  Vector3d position;  // in the shank's frame
  double radius;
};

TEST(Feet, OfEveryShapeTouchWhereTheyAreLowest) {
  const double r = std::sqrt(0.5);
  const FootCase cases[] = {
      {"<geom size=\"0.02\" pos=\"0.01 0 -0.2\"/>", {0.01, 0, -0.2}, 0.02},
      {"<geom type=\"capsule\" fromto=\"0 0 0 0.01 0 -0.2\" size=\"0.015\"/>", {0.01, 0, -0.2}, 0.015},
      {"<geom type=\"capsule\" pos=\"0 0 -0.15\" size=\"0.02 0.05\"/>", {0, 0, -0.2}, 0.02},
      {"<geom type=\"capsule\" pos=\"0 0 -0.2\" euler=\"1.5707963267948966 0 0\" size=\"0.02 0.05\"/>",
       {0, 0, -0.2},
       0.02},
      {"<geom type=\"box\" pos=\"0.02 0 -0.19\" size=\"0.05 0.03 0.01\"/>", {0.02, 0, -0.2}, 0},
      {"<geom type=\"box\" pos=\"0 0 -0.2\" euler=\"0 0.7853981633974483 0\" size=\"0.02 0.03 0.02\"/>",
       {0, 0, -0.2 - 0.04 * r},
       0},
      {"<geom type=\"cylinder\" pos=\"0 0.01 -0.15\" size=\"0.03 0.05\"/>", {0, 0.01, -0.2}, 0},
      {"<geom type=\"cylinder\" pos=\"0 0 -0.2\" euler=\"1.5707963267948966 0 0\" size=\"0.04 0.01\"/>",
       {0, 0, -0.2},
       0.04},
      {"<geom type=\"ellipsoid\" pos=\"0 0 -0.18\" size=\"0.05 0.03 0.02\"/>", {0, 0, -0.2}, 0},
      {"<geom type=\"mesh\" mesh=\"shoe\" pos=\"0 0 -0.2\"/>", {0.01, 0, -0.2}, 0},
      {"<site pos=\"0.02 0 -0.2\" size=\"0.012\"/>", {0.02, 0, -0.2}, 0.012}};
  for (const FootCase& one : cases) {
    const std::string xml = test::hopper_with(one.text);
    const RobotModel robot = parse_robot(xml, "robot.xml");
    ASSERT_EQ(robot.morphology.feet.size(), 1u);
    const Foot& foot = robot.morphology.feet[0];
    EXPECT_EQ(foot.name, "shank");
    EXPECT_LT((foot.position.at(VectorXd()) - one.position).norm(), 1e-7) << one.text;
    EXPECT_EQ(foot.radius, one.radius) << one.text;
    const ModelPointer played = compile_mjcf(played_robot(robot, xml), "played.xml");
    const int geom = mj_name2id(played.get(), mjOBJ_GEOM, "shank");
    ASSERT_GE(geom, 0) << one.text;
    EXPECT_TRUE(played->geom_contype[geom]);
    EXPECT_EQ(played->body_subtreemass[0], compile_mjcf(xml, "x")->body_subtreemass[0]);
  }
}

TEST(Feet, TheLowestCollidingGeomIsItAndABallBeforeItsLike) {
  const auto name = [](const std::string& foot) {
    return parse_robot(test::hopper_with(foot), "robot.xml").morphology.feet[0].name;
  };
  const std::string ball = "<geom name=\"ball\" size=\"0.02\" pos=\"0 0 -0.2\"/>",
                    hull = "<geom name=\"hull\" type=\"box\" size=\"0.03 0.03 0.11\" pos=\"0 0 -0.115\"/>",
                    drawn = "<geom name=\"drawn\" size=\"0.1\" pos=\"0 0 -0.3\" contype=\"0\" conaffinity=\"0\"/>";
  EXPECT_EQ(name(hull + ball + drawn), "ball");  // 5 mm higher than the hull
  EXPECT_EQ(name(test::with(hull, "0.11\"", "0.13\"") + ball), "hull");
}

TEST(Feet, KeepTheirPlaceWhenTheLegTurnsAndStretches) {
  // Turned far, another face of the box would be the lowest at home.
  std::string xml = test::hopper_with(
      "<geom type=\"box\" pos=\"0.02 0 -0.1\" size=\"0.05 0.03 0.1\"/>", 0.2);
  xml = test::with(
      xml, "<keyframe>",
      "<custom><numeric name=\"legwright/yaw\" data=\"0 -1.5 1.5\"/>"
      "<text name=\"legwright/yaw\" data=\"rad | axis z: knee | y\"/>"
      "<numeric name=\"legwright/long\" data=\"0.2 0.1 0.4\"/>"
      "<text name=\"legwright/long\" data=\"m | stretch z: shank | l\"/></custom><keyframe>");
  xml = test::with(xml, "0 0.2\"/></keyframe>", "0 1.1\"/></keyframe>");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  std::mt19937 random(8);
  for (int trial = 0; trial < 20; ++trial) {
    const VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);  // verifies the foot
    const ModelPointer model = compile_mjcf(text, "x");
    EXPECT_NEAR(robot.morphology.feet[0].position.at(s).z(),
                model->geom_pos[2] - model->geom_size[2], 1e-12);
  }
}

TEST(Feet, NamesThatAreTakenAreNotTakenAgain) {
  const std::string xml = test::with(test::hopper_with("<geom size=\"0.02\" pos=\"0 0 -0.2\"/>"),
                                     "<body name=\"thigh\">",
                                     "<geom name=\"shank\" size=\"0.01\"/><body name=\"thigh\">");
  EXPECT_EQ(parse_robot(xml, "robot.xml").morphology.feet[0].name, "shank_foot");
}

// ------------------------------------------------------------------- frames, meshes, rods, angles

std::string calf(const std::string& parts) {
  return test::with(test::hopper_with(parts + "<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>"),
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
           "<geom type=\"box\" pos=\"0.05 0 0.02\" size=\"0.03 0.01 0.02\" contype=\"0\" conaffinity=\"0\"/>"
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

TEST(Stretched, DrawnMeshesScaleWhereAllThatShowThemAgree) {
  const std::string mesh =
      "<geom type=\"mesh\" mesh=\"shoe\" mass=\"0\" contype=\"0\" conaffinity=\"0\" pos=\"0 0 -0.1\"/>";
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
  const std::string turned = test::with(mesh, "pos=", "euler=\"0 1.5707963267948966 0\" pos=");
  EXPECT_EQ(scale(stretched(calf(turned), 0.4)), "2 1 1");
  EXPECT_EQ(scale(stretched(calf(mesh + turned), 0.4)), "");  // they disagree
  EXPECT_EQ(scale(stretched(calf(test::with(mesh, "pos=", "euler=\"0 0.3 0\" pos=")), 0.4)), "");
  EXPECT_EQ(scale(stretched(test::with(calf(mesh), "<body name=\"thigh\">",
                                       mesh + "<body name=\"thigh\">"),
                            0.4)),
            "");  // the trunk shows it too
  EXPECT_EQ(scale(stretched(calf("<geom type=\"mesh\" mesh=\"shoe\" pos=\"0 0 -0.1\"/>"), 0.4)), "");
}

TEST(Stretched, RodsPlacedByPosGrowWhereTheyMakeUpTheLink) {
  const auto size = [](const std::string& rod) {
    const ModelPointer model = compile_mjcf(stretched(calf(rod), 0.4), "x");
    return model->geom_size[1];
  };
  EXPECT_EQ(size("<geom type=\"cylinder\" size=\"0.01 0.09\" pos=\"0 0 -0.09\"/>"), 0.18);
  EXPECT_EQ(size("<geom type=\"capsule\" size=\"0.01 0.09\" pos=\"0 0 -0.09\"/>"), 0.18);
  EXPECT_EQ(size("<geom type=\"cylinder\" size=\"0.02 0.02\" pos=\"0 0 -0.09\"/>"), 0.02);  // a motor
  EXPECT_EQ(size("<geom type=\"cylinder\" size=\"0.02 0.09\" pos=\"0 0 -0.05\" euler=\"1.57 0 0\"/>"),
            0.09);
}

TEST(Stretched, APrintedBodyKeepsTheWeightOfMeshesAndOfWhatHasAMass) {
  std::string xml = calf(
      "<geom type=\"capsule\" size=\"0.01 0.09\" pos=\"0 0 -0.1\"/>"
      "<geom type=\"box\" size=\"0.01 0.02 0.03\" pos=\"0 0 -0.05\" mass=\"0.2\"/>"
      "<geom type=\"mesh\" mesh=\"shoe\" pos=\"0.01 0 -0.15\" euler=\"0.2 0.1 0\" contype=\"0\" conaffinity=\"0\"/>");
  xml = test::with(xml,
                   "<joint name=\"knee\" axis=\"0 1 0\"/>\n          <inertial pos=\"0 0 -0.1\" "
                   "mass=\"0.1\" diaginertia=\"1e-4 1e-4 1e-5\"/>",
                   "<joint name=\"knee\" axis=\"0 1 0\"/>");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  const double before = compile_mjcf(xml, "x")->body_mass[3];
  for (const double length : {0.1, 0.15, 0.3, 0.4}) {
    const double after = compile_mjcf(stretched(xml, length), "x")->body_mass[3];
    const double grown = 1000 * M_PI * 1e-4 * 0.18 * (length / 0.2 - 1);
    EXPECT_NEAR(after - before, grown, 1e-12);
  }
  const std::string two = test::with(
      xml, "<geom type=\"capsule\"",
      "<geom type=\"mesh\" mesh=\"shoe\" pos=\"0 0 -0.1\"/><geom type=\"capsule\"");
  EXPECT_TRUE(holds(complaint(two), "one of several meshes with a weight"));
  EXPECT_EQ(complaint(test::with(two, "pos=\"0 0 -0.1\"/><geom type=\"capsule\"",
                                 "pos=\"0.1 0 -0.15\"/><geom type=\"capsule\"")),
            "");
  EXPECT_TRUE(holds(complaint(test::with(xml, "autolimits=\"true\"",
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
