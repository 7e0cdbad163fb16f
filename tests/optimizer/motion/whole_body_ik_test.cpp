// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/whole_body_ik.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/flat_biped.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd home(const Morphology& robot) {
  VectorXd q = VectorXd::Zero(robot.pose_size());
  q.tail(robot.joint_count()) = robot.nominal_joints();
  return q;
}

TEST(WholeBodyIk, FindsTheFeetOfAPose) {
  const test::Puppy puppy = test::make_puppy(true);
  VectorXd s = puppy.space.initial();
  for (int k = 6; k < 18; ++k) s[k] = 0.3 * (k % 3);  // axes that let feet go anywhere
  const GeometryAtDesign geometry(puppy.morphology, s);
  WholeBodyIk ik(puppy.morphology, geometry, {.pose = 1e-9});
  VectorXd there = VectorXd::Zero(puppy.morphology.pose_size());
  there.tail(12) = puppy.morphology.nominal_joints();
  VectorXd q = there;
  for (int k = 6; k < 18; ++k) there[k] += k % 2 == 0 ? 0.2 : -0.15;
  there.head<3>() = Vector3d(0.01, -0.02, 0.2);
  const WholeBodyIk::Places wanted = ik.places_at(there);
  const auto miss = [&](const VectorXd& pose) {
    const WholeBodyIk::Places at = ik.places_at(pose);
    double most = (at.com - wanted.com).norm();
    for (int j = 0; j < 4; ++j) most = std::max(most, (at.feet[j] - wanted.feet[j]).norm());
    return most;
  };
  EXPECT_GT(miss(q), 0.05);
  ik.improve(wanted, 100, q);
  EXPECT_LT(miss(q), 1e-3);
  EXPECT_EQ(q.segment<3>(3).norm(), 0.0);
}

TEST(WholeBodyIk, StaysWithinTheRangesOfTheJointsAndNeverGetsWorse) {
  test::Puppy puppy = test::make_puppy(true);
  for (Link& link : puppy.morphology.links) {
    link.joint.lower = link.joint.nominal - 0.1;
    link.joint.upper = link.joint.nominal + 0.1;
  }
  const VectorXd s = puppy.space.initial(), home = puppy.morphology.nominal_joints();
  const GeometryAtDesign geometry(puppy.morphology, s);
  WholeBodyIk ik(puppy.morphology, geometry, {});
  VectorXd q = VectorXd::Zero(puppy.morphology.pose_size());
  q.tail(12) = home;
  WholeBodyIk::Places wanted = ik.places_at(q);
  for (Vector3d& foot : wanted.feet) foot.x() += 0.5;  // out of reach
  ik.improve(wanted, 50, q);
  EXPECT_TRUE(q.allFinite());
  EXPECT_LT((q.tail(12) - home).lpNorm<Eigen::Infinity>(), 0.1 + 1e-12);
  EXPECT_GT((q.tail(12) - home).lpNorm<Eigen::Infinity>(), 0.05);
}

TEST(WholeBodyIk, MovesTheRootAloneWhereThatIsEnough) {
  const test::Puppy puppy = test::make_puppy(true);
  const GeometryAtDesign geometry(puppy.morphology, puppy.space.initial());
  WholeBodyIk ik(puppy.morphology, geometry, {});
  VectorXd q = home(puppy.morphology);
  const VectorXd joints = q.tail(12);
  WholeBodyIk::Places wanted = ik.places_at(q);
  const Vector3d shift(0.03, -0.02, 0.11);
  wanted.com += shift;
  for (Vector3d& foot : wanted.feet) foot += shift;
  ik.improve(wanted, 60, q);
  EXPECT_LT((q.head<3>() - shift).norm(), 1e-7);
  EXPECT_LT((q.tail(12) - joints).norm(), 1e-5);
}

TEST(WholeBodyIk, KeepsTheTrunksOrientation) {
  const test::Puppy puppy = test::make_puppy(true);
  const GeometryAtDesign geometry(puppy.morphology, puppy.space.initial());
  WholeBodyIk ik(puppy.morphology, geometry, {});
  VectorXd q = home(puppy.morphology);
  q.segment<3>(3) = Vector3d(0.05, -0.1, 0.4);
  WholeBodyIk::Places wanted = ik.places_at(q);
  wanted.feet[0].z() += 0.03;
  const double before = (ik.places_at(q).feet[0] - wanted.feet[0]).norm();
  ik.improve(wanted, 60, q);
  EXPECT_EQ(q.segment<3>(3), Vector3d(0.05, -0.1, 0.4));
  EXPECT_LT((ik.places_at(q).feet[0] - wanted.feet[0]).norm(), 0.2 * before);
}

TEST(WholeBodyIk, WeightsSayWhatIsMissedWhereNotAllCanBeMet) {
  test::Puppy puppy = test::make_puppy(true);
  const GeometryAtDesign geometry(puppy.morphology, puppy.space.initial());
  const auto miss_of_com = [&](double weight) {
    WholeBodyIk ik(puppy.morphology, geometry,
                   {.com = Vector3d::Constant(weight), .foot = Vector3d::Ones()});
    VectorXd q = home(puppy.morphology);
    WholeBodyIk::Places wanted = ik.places_at(q);
    wanted.com.z() += 0.2;  // legs are not as long
    ik.improve(wanted, 100, q);
    return (ik.places_at(q).com - wanted.com).norm();
  };
  const double heavy = miss_of_com(100.0), light = miss_of_com(0.01);
  EXPECT_LT(heavy, 0.05);
  EXPECT_GT(light, 0.1);
}

TEST(WholeBodyIk, LaysSolesDownInTheHeading) {
  const double splay = 0.2;
  const test::Puppy biped = test::make_flat_biped(splay);
  const GeometryAtDesign geometry(biped.morphology, biped.space.initial());
  WholeBodyIk ik(biped.morphology, geometry, {.pose = 1e-9});
  VectorXd q = home(biped.morphology);
  WholeBodyIk::Places wanted = ik.places_at(q);
  wanted.heading = 0.15;
  wanted.com.x() += 0.03;  // bent ankles would tilt the soles
  ik.improve(wanted, 100, q);
  PoseKinematics pose;
  pose.compute(biped.morphology, geometry, q, PoseDetail::place);
  for (int j = 0; j < 2; ++j) {
    const Foot& foot = biped.morphology.feet[j];
    const Vector3d ahead = pose.rotation(foot.link) * foot.sole->ahead,
                   beside = pose.rotation(foot.link) * foot.sole->beside;
    EXPECT_NEAR(ahead.z(), 0.0, 2e-3);
    EXPECT_NEAR(beside.z(), 0.0, 2e-3);
    EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), 0.15 + (j == 0 ? splay : -splay), 2e-3);
    EXPECT_LT((foot_place(biped.morphology, geometry, pose, j) - wanted.feet[j]).norm(), 2e-3);
  }
}

}  // namespace
}  // namespace legwright
