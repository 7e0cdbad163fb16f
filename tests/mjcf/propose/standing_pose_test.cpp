// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/standing_pose.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <tuple>

#include "mjcf/propose/proposals.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/numbers.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kLurcherFile = "lurcher.xml";

/// Of tests/robots: no keyframe, straight legs out of their ranges, the trunk's frame on the
/// ground.
std::string lurcher() {
  return test::read_file(test::source_path("tests/robots/lurcher/robot.xml"));
}

std::string with_home(const std::string& xml, double trunk, const std::string& legs) {
  return test::with(xml, "</mujoco>",
                    fmt::format("<keyframe><key name=\"home\" qpos=\"0 0 {} 1 0 0 0 {}\"/>"
                                "</keyframe></mujoco>",
                                trunk, legs));
}

std::string four(const std::string& leg) { return leg + " " + leg + " " + leg + " " + leg; }

/// A hexapod drawn with its legs stretched out level, in degrees, without keyframe.
TEST(StandingPose, IsFoundForLegsThatLieFlat) {
  const char* const file = "crab.xml";
  std::string crab = test::read_file(test::source_path("tests/robots/crab/robot.xml"));
  EXPECT_FALSE(find_standing_pose(crab, file)) << "it stands";
  const std::size_t from = crab.find("  <keyframe>");
  crab.erase(from, crab.find("</keyframe>") + 11 - from);
  const auto pose = find_standing_pose(crab, file);
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("lie flat"), std::string::npos) << pose->why;
  EXPECT_NE(pose->words.find(" degrees"), std::string::npos) << pose->words;
  const ProposedParameters found = propose_parameters(with_keyframe(crab, file, *pose), file);
  EXPECT_EQ(found.not_standing, "");
  for (const Limb& limb : found.limbs) {  // its hips are at 0.1 m and 0.11 m
    EXPECT_LT(limb.home.z(), -0.04);
    EXPECT_GT(std::abs(limb.home.x()), 0.15);
  }
}

/// A quadruped drawn on bent legs, its trunk's frame where the CAD program has it.
std::string drawn_standing(double trunk_height, double pelvis_x) {
  std::string legs, servos;
  for (const auto& [name, x, y] : {std::tuple{"fl", .15, .08}, std::tuple{"fr", .15, -.08},
                                   std::tuple{"hl", -.15, .08}, std::tuple{"hr", -.15, -.08}}) {
    legs += fmt::format(
        R"(<body name="{0}_thigh" pos="{1} {2} 0" euler="0 .6 0"><joint name="{0}_hip" axis="0 1 0"/>
        <inertial pos="0 0 -.1" mass=".3" diaginertia="1e-3 1e-3 1e-4"/>
        <body name="{0}_shank" pos="0 0 -.2" euler="0 -1.2 0"><joint name="{0}_knee" axis="0 1 0"/>
        <inertial pos="0 0 -.1" mass=".1" diaginertia="5e-4 5e-4 1e-5"/>
        <geom name="{0}_foot" size=".02" pos="0 0 -.2"/></body></body>)",
        name, x, y);
    for (const char* joint : {"hip", "knee"})
      servos += fmt::format(R"(<position joint="{}_{}" kp="200" forcerange="-9 9"/>)", name, joint);
  }
  return fmt::format(
             R"(<mujoco><compiler angle="radian"/><worldbody><body name="trunk" pos="0 0 {}">
             <freejoint/><inertial pos="{} 0 0" mass="4" diaginertia=".02 .05 .05"/>)",
             trunk_height, pelvis_x) +
         legs + "</body></worldbody><actuator>" + servos + "</actuator></mujoco>";
}

TEST(StandingPose, OneThatTheFileDrawsIsPutOnTheGround) {
  const double stands = 0.4 * std::cos(0.6) + 0.02;
  EXPECT_FALSE(find_standing_pose(drawn_standing(stands, 0.0), "dog.xml"));
  const auto pose = find_standing_pose(drawn_standing(0.0, 0.0), "dog.xml");
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("0.35 m below the ground"), std::string::npos) << pose->why;
  const std::vector<double> qpos = *parse_numbers(pose->qpos);
  EXPECT_NEAR(qpos[2], stands, 1e-6);
  for (std::size_t k = 7; k < qpos.size(); ++k) EXPECT_EQ(qpos[k], 0.0);
}

/// An ant: its feet cannot come below its hips, and hang lowest before they are nearest.
TEST(StandingPose, IsFoundWhereAFootHangsLowestBesideItsPlace) {
  std::string legs;
  for (const auto& [k, x, y] :
       {std::tuple{1, 1, 1}, std::tuple{2, -1, 1}, std::tuple{3, -1, -1}, std::tuple{4, 1, -1}})
    legs += fmt::format(
        R"(<body name="leg{0}" pos="{1} {2} 0"><joint name="hip{0}" axis="0 0 1" range="-40 40"/>
        <geom type="capsule" size=".08" fromto="0 0 0 {1} {2} 0" mass=".1"/>
        <body name="foot{0}" pos="{1} {2} 0">
        <joint name="ankle{0}" axis="{3} {4} 0" range="30 100"/>
        <geom type="capsule" size=".08" fromto="0 0 0 {5} {6} 0" mass=".1"/></body></body>)",
        k, 0.2 * x, 0.2 * y, -y, x, 0.4 * x, 0.4 * y);
  const auto pose = find_standing_pose(
      R"(<mujoco><worldbody><body name="torso" pos="0 0 .75"><freejoint/>
      <geom size=".25" mass=".3"/>)" +
          legs + "</body></worldbody></mujoco>",
      "ant.xml");
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("outside of its range 30 to 100 degrees"), std::string::npos);
}

TEST(StandingPose, OneThatTipsOverIsNone) {
  const double stands = 0.4 * std::cos(0.6) + 0.02;
  const auto pose = find_standing_pose(drawn_standing(stands, 0.15), "dog.xml");
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("off the middle of its feet"), std::string::npos) << pose->why;
  const std::vector<double> qpos = *parse_numbers(pose->qpos);
  EXPECT_GT(std::abs(qpos[7]), 0.05) << "the feet go below the centre of mass";
}

TEST(StandingPose, IsFoundWithinRangesLevelAndUnderTheHips) {
  EXPECT_THROW(parse_robot(lurcher(), kLurcherFile), InputError);
  const auto pose = find_standing_pose(lurcher(), kLurcherFile);
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("'lf_knee' is at 0 rad there, outside of its range"), std::string::npos)
      << pose->why;
  const std::string text = with_keyframe(lurcher(), kLurcherFile, *pose);
  const ProposedParameters found = propose_parameters(text, kLurcherFile);
  EXPECT_EQ(found.not_standing, "");
  EXPECT_EQ(found.limbs.size(), 4u);
  for (const Joint& joint :
       {found.model.morphology.links[2].joint, found.model.morphology.links[3].joint}) {
    EXPECT_GT(joint.nominal, joint.lower + 0.05);
    EXPECT_LT(joint.nominal, joint.upper - 0.05);
  }
  const ModelPointer model = compile_mjcf(text, kLurcherFile);
  const DataPointer data = kinematics_at(*model, home_qpos(*model), kLurcherFile);
  mj_comPos(model.get(), data.get());
  double middle = 0.0;
  for (const FootContact& foot : found.model.structure.feet) {
    EXPECT_NEAR(lowest_point(*model, *data, foot.geom), 0.0, 2e-6) << foot.name;
    middle += data->geom_xpos[3 * foot.geom] / 4;
  }
  EXPECT_NEAR(middle, data->subtree_com[3], 0.01);
  // Left and right are mirror images, so that init ties them.
  EXPECT_TRUE(std::any_of(found.proposals.begin(), found.proposals.end(), [](const Proposal& p) {
    return p.binding == "stretch link: lf_shank rf_shank";
  }));
}

/// Ranges that hold the legs folded.
TEST(StandingPose, WhereThereIsNoneItIsTold) {
  const std::string xml = lurcher();
  std::string none = "unchanged";
  EXPECT_TRUE(find_standing_pose(xml, kLurcherFile, &none));
  EXPECT_EQ(none, "");
  const std::regex knees("(joint name=\"[a-z]+_knee\"[^>]*range=\")[^\"]*");
  const std::string folded = std::regex_replace(xml, knees, "$012.9 3.0");
  ASSERT_NE(folded, xml);
  EXPECT_FALSE(find_standing_pose(folded, kLurcherFile, &none));
  EXPECT_NE(none.find("no other was found"), std::string::npos) << none;
}

/// Shanks that are meshes, leaning as their part was drawn: the foot is where they are lowest, far
/// from their middle.
TEST(StandingPose, PutsTheLowestPartOfAMeshUnderTheHips) {
  std::string legs, servos;
  for (const auto& [name, x, y] : {std::tuple{"fl", .1, .05}, std::tuple{"fr", .1, -.05},
                                   std::tuple{"hl", -.1, .05}, std::tuple{"hr", -.1, -.05}}) {
    legs += fmt::format(R"(<body name="{0}_thigh" pos="{1} {2} 0">
        <joint name="{0}_hip" axis="0 1 0" range="-1.5 0.3"/>
        <inertial pos="0 0 -.05" mass=".05" diaginertia="1e-4 1e-4 1e-4"/>
        <body name="{0}_shank" pos="0 0 -.1"><joint name="{0}_knee" axis="0 1 0" range=".2 1.5"/>
        <inertial pos="0 0 -.05" mass=".05" diaginertia="1e-4 1e-4 1e-4"/>
        <geom type="mesh" mesh="shank" mass="0"/></body></body>)",
                        name, x, y);
    for (const char* joint : {"hip", "knee"})
      servos += fmt::format(R"(<position joint="{}_{}" kp="50" forcerange="-5 5"/>)", name, joint);
  }
  const std::string text =
      R"(<mujoco><compiler angle="radian"/><asset><mesh name="shank" vertex=".01 .01 0 .01 -.01 0
      -.01 .01 0 -.01 -.01 0 .06 .005 -.12 .06 -.005 -.12 .05 .005 -.12 .05 -.005 -.12"/></asset>
      <worldbody><body name="trunk"><freejoint/>
      <inertial pos="0 0 0" mass="2" diaginertia=".01 .01 .01"/>)" +
      legs + "</body></worldbody><actuator>" + servos + "</actuator></mujoco>";
  const auto pose = find_standing_pose(text, "robot.xml");
  ASSERT_TRUE(pose);
  const ProposedParameters found =
      propose_parameters(with_keyframe(text, "robot.xml", *pose), "robot.xml");
  EXPECT_EQ(found.not_standing, "");
  ASSERT_EQ(found.limbs.size(), 4u);
  for (const Limb& limb : found.limbs)
    EXPECT_NEAR(limb.home.x(), limb.row == 0 ? 0.1 : -0.1, 0.02) << limb.row;
}

/// The user's file says degrees: so do messages about it.
TEST(StandingPose, RangesAreToldInTheUnitOfTheFile) {
  std::string degrees = lurcher();
  degrees = test::with(degrees, "angle=\"radian\"", "angle=\"degree\"");
  for (const auto& [from, to] : {std::pair{"range=\"-2.6 -0.3\"", "range=\"-150 -17\""},
                                 {"range=\"-0.7 0.7\"", "range=\"-40 40\""},
                                 {"range=\"-1.2 2.6\"", "range=\"-69 149\""}})
    for (std::size_t at = 0; (at = degrees.find(from, at)) != std::string::npos;)
      degrees.replace(at, std::string(from).size(), to);
  const auto pose = find_standing_pose(degrees, kLurcherFile);
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("is at 0 degrees there, outside of its range -150 to -17 degrees"),
            std::string::npos)
      << pose->why;
}

TEST(StandingPose, IsTheSameEachTime) {
  EXPECT_EQ(find_standing_pose(lurcher(), kLurcherFile)->qpos,
            find_standing_pose(lurcher(), kLurcherFile)->qpos);
}

TEST(StandingPose, AFoldedHomeIsNone) {
  const auto folded =
      find_standing_pose(with_home(lurcher(), -0.2, four("0 1.45 -2.6")), kLurcherFile);
  ASSERT_TRUE(folded);
  EXPECT_NE(folded->why.find("folded"), std::string::npos) << folded->why;
}

TEST(StandingPose, LegsOfOneBuildInTheAirAreLegs) {
  const std::string half = with_home(lurcher(), -0.1, "0 0.5 -1 0 0.5 -1 0 2.5 -2.6 0 2.5 -2.6");
  EXPECT_LT(parse_robot(half, kLurcherFile).morphology.foot_count(), 4);  // what it was read as
  const auto pose = find_standing_pose(half, kLurcherFile);
  ASSERT_TRUE(pose);
  const RobotModel robot = parse_robot(with_keyframe(half, kLurcherFile, *pose), kLurcherFile);
  EXPECT_EQ(robot.morphology.foot_count(), 4);
  EXPECT_EQ(robot.morphology.joint_count(), 12);
}

/// Two legs up in the air, whose shanks point upwards, are no shorter for it.
TEST(StandingPose, LegsAreOfOneBuildInAnyPose) {
  const std::string reared =
      with_home(lurcher(), 0.0, "0 -2.2 -1.3 0 -2.2 -1.3 0 0.7 -1.4 0 0.7 -1.4");
  const auto pose = find_standing_pose(
      test::with(test::with(reared, "-1.2 2.6", "-2.5 2.6"), "-1.2 2.6", "-2.5 2.6"), kLurcherFile);
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("legs of one build end there at heights that differ"), std::string::npos)
      << pose->why;
}

/// A waist is no hinge of the two legs that hang on it.
TEST(StandingPose, AWaistStaysAtRest) {
  std::string xml =
      test::with(lurcher(), "      <body name=\"lh_hip\"",
                 "      <body name=\"waist\"><inertial pos=\"0 0 0.3\" mass=\"1\" "
                 "diaginertia=\".01 .01 .01\"/>"
                 "<joint name=\"waist\" axis=\"0 1 0\" range=\"-1 1\"/><body name=\"lh_hip\"");
  const std::string end = "    </body>\n  </worldbody>";
  xml = test::with(xml, end, "      </body>\n" + end);
  xml = test::with(xml, "<motor name", "<motor joint=\"waist\" ctrlrange=\"-9 9\"/><motor name");
  const auto pose = find_standing_pose(xml, kLurcherFile);
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->words.find("waist"), std::string::npos) << pose->words;
  const auto model = compile_mjcf(with_keyframe(xml, kLurcherFile, *pose), kLurcherFile);
  const int waist = mj_name2id(model.get(), mjOBJ_JOINT, "waist");
  ASSERT_GE(waist, 0);
  EXPECT_EQ(home_qpos(*model)[model->jnt_qposadr[waist]], 0.0);
}

/// Angles of a found pose, as they stand in its keyframe.
std::vector<double> legs_in(const std::string& xml) {
  const auto pose = find_standing_pose(xml, kLurcherFile);
  EXPECT_TRUE(pose);
  if (!pose) return std::vector<double>(12, 0.0);
  std::vector<double> all = *parse_numbers(pose->qpos);
  all.erase(all.begin(), all.begin() + 7);
  return all;
}

TEST(StandingPose, OfMirroredLegsIsMirrored) {
  const std::vector<double> angles = legs_in(lurcher());
  for (const std::size_t left : {0, 6})
    for (const std::size_t k : {0, 1, 2})
      EXPECT_NEAR(angles[left + k], (k == 0 ? -1 : 1) * angles[left + 3 + k], 2e-6) << left << k;
}

/// A CAD program draws each leg as it happens to lie there: zeros differ, the mechanism does not.
TEST(StandingPose, OfMirroredLegsDrawnAtOtherAnglesIsMirrored) {
  std::string xml = test::with(lurcher(), "<body name=\"rf_shank\" pos=\"0 0 -0.2\">",
                               "<body name=\"rf_shank\" pos=\"0 0 -0.2\" euler=\"0 -0.7 0\">");
  xml = test::with(xml, "\"rf_knee\" axis=\"0 1 0\" range=\"-2.6 -0.3\"",
                   "\"rf_knee\" axis=\"0 -1 0\" range=\"-0.4 1.9\"");
  const std::vector<double> angles = legs_in(xml), plain = legs_in(lurcher());
  EXPECT_NEAR(angles[5], -plain[5] - 0.7, 2e-6) << "rf_knee";
  for (const std::size_t k : {0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11})
    EXPECT_NEAR(angles[k], plain[k], 2e-6) << k;
}

/// The pose that the file draws stands, but its legs could not be tied.
TEST(StandingPose, LegsDrawnAtOtherAnglesStandAsThoseTheyMirror) {
  const char* const file = "dog.xml";
  const std::string left = "<body name=\"fr_thigh\" pos=\"0.15 -0.08 0\" euler=\"0 ";
  const std::string xml = test::with(drawn_standing(0.350134, 0.0), left + ".6", left + ".4");
  EXPECT_LT(propose_parameters(xml, file).limbs[0].partner, 0);
  const auto pose = find_standing_pose(xml, file);
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->why.find("at other angles left and right: joint 'fr_hip' by 0.2 rad"),
            std::string::npos)
      << pose->why;
  const std::vector<double> qpos = *parse_numbers(pose->qpos);
  for (std::size_t k = 7; k < qpos.size(); ++k) EXPECT_NEAR(qpos[k], k == 9 ? 0.2 : 0.0, 1e-6) << k;
  const ProposedParameters found = propose_parameters(with_keyframe(xml, file, *pose), file);
  EXPECT_EQ(found.limbs[0].partner, 1);
  EXPECT_TRUE(std::any_of(found.proposals.begin(), found.proposals.end(), [](const Proposal& p) {
    return p.binding == "stretch link: fl_thigh fr_thigh";
  }));
}

/// A robot that is drawn facing along y finds the pose of the one that faces along x.
TEST(StandingPose, DoesNotAskWhereTheRobotFaces) {
  const std::vector<double> straight = legs_in(lurcher());
  std::string turned = lurcher();
  for (const auto& [from, to] : {std::pair{"axis=\"0 1 0\"", "axis=\"-1 0 0 \""},
                                 {"axis=\"1 0 0\"", "axis=\"0 1 0\""},
                                 {"pos=\"0 0.06 0\"", "pos=\"-0.06 0 0\""},
                                 {"pos=\"0 -0.06 0\"", "pos=\"0.06 0 0\""},
                                 {"pos=\"0.18 0.05 ", "pos=\"-0.05 0.18 "},
                                 {"pos=\"0.18 -0.05 ", "pos=\"0.05 0.18 "},
                                 {"pos=\"-0.18 0.05 ", "pos=\"-0.05 -0.18 "},
                                 {"pos=\"-0.18 -0.05 ", "pos=\"0.05 -0.18 "},
                                 {"size=\"0.2 0.06 0.05\"", "size=\"0.06 0.2 0.05\""}})
    for (std::size_t at = 0; (at = turned.find(from, at)) != std::string::npos;)
      turned.replace(at, std::string(from).size(), to);
  const std::vector<double> found = legs_in(turned);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_NEAR(found[k], straight[k], 2e-6) << k;
}

/// Ankles that roll are no knees: legs bend ahead, and their feet stand below the centre of mass.
TEST(StandingPose, OfABipedOnAnklesIsMirroredAndBalanced) {
  std::string xml = test::read_file(test::source_path("tests/robots/porter/robot.xml"));
  xml = test::with(xml, "range=\"0 2.3\"", "range=\"0.2 2.3\"");
  const std::size_t begin = xml.find("<keyframe>"), end = xml.find("</keyframe>");
  xml.erase(begin, end + 11 - begin);
  const auto pose = find_standing_pose(xml, "porter.xml");
  ASSERT_TRUE(pose);
  const ModelPointer model = compile_mjcf(with_keyframe(xml, "porter.xml", *pose), "porter.xml");
  const auto angle = [&](const std::string& joint) {
    const int id = mj_name2id(model.get(), mjOBJ_JOINT, joint.c_str());
    return home_qpos(*model)[model->jnt_qposadr[id]];
  };
  for (const char* joint : {"hip_pitch", "knee", "ankle_pitch"})
    EXPECT_NEAR(angle(std::string("left_") + joint), angle(std::string("right_") + joint), 1e-4)
        << joint;
  for (const char* joint : {"hip_yaw", "hip_roll", "ankle_roll"})
    EXPECT_NEAR(angle(std::string("left_") + joint), -angle(std::string("right_") + joint), 1e-4)
        << joint;
  const DataPointer data = kinematics_at(*model, home_qpos(*model), "porter.xml");
  mj_comPos(model.get(), data.get());
  const int trunk = mj_name2id(model.get(), mjOBJ_BODY, "pelvis"),
            foot = mj_name2id(model.get(), mjOBJ_BODY, "left_foot");
  EXPECT_LT(std::abs(data->subtree_com[3 * trunk] - data->xpos[3 * foot]), 0.1);
}

/// Toes of one hinge each are no legs on a waist.
TEST(StandingPose, OfLegsWithToesIsFound) {
  std::string xml = lurcher();
  for (const std::string leg : {"lf", "rf", "lh", "rh"}) {
    std::string toes;
    for (const char* toe : {"1", "2"})
      toes += "<body name=\"" + leg + toe +
              "\" pos=\"0.01 0 -0.2\"><inertial pos=\"0 0 0\" "
              "mass=\"0.01\" diaginertia=\"1e-5 1e-5 1e-5\"/><joint name=\"" +
              leg + toe + "\" axis=\"0 1 0\" range=\"-0.1 0.1\"/><geom class=\"ball\"/></body>";
    const std::string foot = "<geom name=\"" + leg + "_foot\" class=\"ball\" pos=\"0 0 -0.2\"/>";
    xml = test::with(xml, foot, toes);
  }
  const auto pose = find_standing_pose(xml, kLurcherFile);
  ASSERT_TRUE(pose);
  EXPECT_NE(pose->words.find("lf_knee"), std::string::npos) << pose->words;
}

TEST(StandingPose, APoseThatStandsIsLeftAlone) {
  EXPECT_FALSE(find_standing_pose(with_home(lurcher(), 0.0, four("0 0.7 -1.4")), kLurcherFile));
  for (const char* name : {"puppy", "quadruped", "hexapod", "biped", "printed_quadruped"})
    EXPECT_FALSE(find_standing_pose(test::example_robot(name), "robot.xml")) << name;
}

TEST(StandingPose, HoldsPositionServosThere) {
  std::string servos = lurcher();
  for (std::size_t at; (at = servos.find("<motor name")) != std::string::npos;)
    servos.replace(at, 6, "<position kp=\"60\"");
  const auto pose = find_standing_pose(servos, kLurcherFile);
  ASSERT_TRUE(pose);
  const auto qpos = parse_numbers(pose->qpos.c_str()), ctrl = parse_numbers(pose->ctrl.c_str());
  ASSERT_TRUE(qpos && ctrl);
  EXPECT_TRUE(std::equal(ctrl->begin(), ctrl->end(), qpos->begin() + 7));
}

}  // namespace
}  // namespace legwright
