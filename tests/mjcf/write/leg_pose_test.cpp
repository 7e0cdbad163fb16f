// SPDX-License-Identifier: Apache-2.0
// Inverse kinematics of one leg: the foot's height to rounding, the rest as near as it goes.
#include "mjcf/write/leg_pose.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/flat_biped.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd home(const Morphology& robot) {
  VectorXd q = VectorXd::Zero(robot.pose_size());
  q.tail(robot.joint_count()) = robot.nominal_joints();
  return q;
}

/// Trunk and a leg of two parallel hinges about −y, links of 0.1 m.
Morphology two_hinges() {
  Morphology robot;
  robot.leg_length = 0.2;
  robot.links.resize(3);
  for (int l = 1; l <= 2; ++l) {
    robot.links[static_cast<std::size_t>(l)].parent = l - 1;
    robot.links[static_cast<std::size_t>(l)].joint.axis.reference = -Vector3d::UnitY();
  }
  robot.links[2].origin.constant = Vector3d(0.0, 0.0, -0.1);
  for (Link& link : robot.links) link.masses.push_back({1.0, {}});
  robot.feet.push_back({"foot", 2, {Vector3d(0.0, 0.0, -0.1), {}}, 0.01});
  return robot;
}

/// Where the foot of two_hinges() is from its hip.
Vector3d foot_by_hand(double a, double b) {
  return {0.1 * (std::sin(a) + std::sin(a + b)), 0.0, -0.1 * (std::cos(a) + std::cos(a + b))};
}

TEST(LegsOf, JointsThatMoveOneFootOnly) {
  const std::vector<LegJoints> legs = legs_of(test::make_puppy(true).morphology);
  ASSERT_EQ(legs.size(), 4U);
  for (int j = 0; j < 4; ++j) {
    EXPECT_EQ(legs[static_cast<std::size_t>(j)].foot, j);
    EXPECT_EQ(legs[static_cast<std::size_t>(j)].joints,
              (std::vector<int>{3 * j, 3 * j + 1, 3 * j + 2}));
  }
  Morphology forked = two_hinges();  // a second foot on the upper link shares its hinge
  forked.feet.push_back({"heel", 1, {Vector3d(0.0, 0.0, -0.1), {}}, 0.01});
  EXPECT_EQ(legs_of(forked)[0].joints, (std::vector<int>{1}));
  EXPECT_TRUE(legs_of(forked)[1].joints.empty());
}

TEST(PosedRobot, PlacesAFootWhereItIsByHand) {
  const Morphology robot = two_hinges();
  const PosedRobot posed(robot, VectorXd(0));
  VectorXd pose = VectorXd::Zero(8);
  pose.head<3>() = Vector3d(0.3, -0.2, 0.5);
  pose.tail<2>() << 0.4, -0.9;
  const Vector3d reach = foot_by_hand(0.4, -0.9);
  EXPECT_LT((posed.foot(pose, 0) - (pose.head<3>() + reach)).norm(), 1e-15);
  EXPECT_LT((posed.reach(pose, legs_of(robot)[0]) - reach).norm(), 1e-15);
  EXPECT_FALSE(posed.sole(pose, 0));
}

TEST(LegPose, FindsTheAnglesOfAPlaceInReach) {
  const Morphology robot = two_hinges();
  const PosedRobot posed(robot, VectorXd(0));
  const LegJoints leg = legs_of(robot)[0];
  VectorXd pose = VectorXd::Zero(8);
  pose[2] = 0.2;
  pose.tail<2>() << 0.4, -0.9;
  const Vector3d wanted = foot_by_hand(0.6, -1.1);
  ASSERT_TRUE(posed.solve(pose, leg, {0.2 + wanted.z(), wanted.head<2>(), {}}));
  EXPECT_NEAR(posed.foot(pose, 0).z(), 0.2 + wanted.z(), 1e-13);
  // The height is exact; the place from above gives way a little to the angles of the start.
  EXPECT_NEAR(posed.reach(pose, leg).x(), wanted.x(), 1e-4);
  EXPECT_NEAR(pose[6], 0.6, 0.01);
  EXPECT_NEAR(pose[7], -1.1, 0.01);
  EXPECT_EQ(pose.head<6>(), (VectorXd(6) << 0.0, 0.0, 0.2, 0.0, 0.0, 0.0).finished());
}

TEST(LegPose, LeavesALegThatStandsAlone) {
  const Morphology robot = two_hinges();
  const PosedRobot posed(robot, VectorXd(0));
  const LegJoints leg = legs_of(robot)[0];
  VectorXd pose = VectorXd::Zero(8);
  pose.tail<2>() << 0.4, -0.9;
  const VectorXd before = pose;
  ASSERT_TRUE(
      posed.solve(pose, leg, {posed.foot(pose, 0).z(), posed.reach(pose, leg).head<2>(), {}}));
  EXPECT_EQ(pose, before);
}

TEST(LegPose, SaysWhereAHeightIsOutOfReach) {
  const Morphology robot = two_hinges();
  const PosedRobot posed(robot, VectorXd(0));
  VectorXd pose = VectorXd::Zero(8);
  pose.tail<2>() << 0.4, -0.9;
  EXPECT_FALSE(posed.solve(pose, legs_of(robot)[0], {-0.21, Vector2d::Zero(), {}}));
  pose.tail<2>() << 0.4, -0.9;
  EXPECT_TRUE(posed.solve(pose, legs_of(robot)[0], {-0.199, Vector2d::Zero(), {}}));
}

TEST(LegPose, TheHeightComesBeforeThePlaceAndRangesAreKept) {
  Morphology robot = two_hinges();
  robot.links[2].joint.lower = -1.0;
  robot.links[2].joint.upper = -0.8;
  const PosedRobot posed(robot, VectorXd(0));
  VectorXd pose = VectorXd::Zero(8);
  pose.tail<2>() << 0.4, -0.9;
  // Of a knee that hardly bends the foot is on a circle about the hip: not both can be met.
  ASSERT_TRUE(posed.solve(pose, legs_of(robot)[0], {-0.16, Vector2d(0.02, 0.0), {}}));
  EXPECT_NEAR(posed.foot(pose, 0).z(), -0.16, 1e-13);
  EXPECT_GE(pose[7], -1.0);
  EXPECT_LE(pose[7], -0.8);
  EXPECT_GT(std::abs(posed.foot(pose, 0).x() - 0.02), 1e-3);
}

TEST(LegPose, LaysASoleDown) {
  const test::Puppy biped = test::make_flat_biped(0.1);
  const PosedRobot posed(biped.morphology, biped.space.initial());
  VectorXd pose = home(biped.morphology);
  for (const LegJoints& leg : legs_of(biped.morphology)) {
    const auto sole = posed.sole(pose, leg.foot);
    ASSERT_TRUE(sole);
    const double height = posed.foot(pose, leg.foot).z() + 0.02;
    const Vector2d place = posed.reach(pose, leg).head<2>() + Vector2d(0.03, 0.01);
    VectorXd there = pose;
    ASSERT_TRUE(posed.solve(there, leg, {height, place, sole}));
    EXPECT_NEAR(posed.foot(there, leg.foot).z(), height, 1e-12);
    EXPECT_NEAR(posed.sole(there, leg.foot)->ahead.z(), sole->ahead.z(), 1e-9);
    EXPECT_NEAR(posed.sole(there, leg.foot)->beside.z(), sole->beside.z(), 1e-9);
    EXPECT_LT((posed.reach(there, leg).head<2>() - place).norm(), 2e-3);
    for (int a = 0; a < biped.morphology.joint_count(); ++a) {
      const bool own = std::find(leg.joints.begin(), leg.joints.end(), a) != leg.joints.end();
      if (!own) {
        EXPECT_EQ(there[6 + a], pose[6 + a]) << "a joint of another leg moved";
      }
    }
  }
}

}  // namespace
}  // namespace legwright
