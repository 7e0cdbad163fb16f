// SPDX-License-Identifier: Apache-2.0
// Outputs of kinematics against sums over the point masses, one by one. (Derivatives:
// objective/derivatives_test.)
#include "optimizer/design/momentum.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

class PuppyAtTwoPoses : public testing::Test {
 protected:
  PuppyAtTwoPoses() : puppy_(test::make_puppy(true)), ancestry_(puppy_.morphology) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    s_ = puppy_.space.initial();
    for (int k = 0; k < s_.size(); ++k) s_[k] += 0.1 * puppy_.space.scale()[k] * normal(random);
    geometry_ = GeometryAtDesign(puppy_.morphology, s_);
    for (PoseKinematics& pose : poses_) {
      VectorXd q(puppy_.morphology.pose_size());
      for (double& value : q) value = 0.4 * normal(random);
      pose.compute(puppy_.morphology, geometry_, q, PoseDetail::motion);
    }
    columns_.assign(puppy_.morphology.pose_size() + puppy_.space.size(), 0);
  }
  /// Calls visit(mass, world position at pose 0, at pose 1) for every point mass.
  template <class Visit>
  void for_each_point(Visit visit) const {
    for (std::size_t l = 0; l < puppy_.morphology.links.size(); ++l)
      for (const PointMass& point : puppy_.morphology.links[l].masses) {
        const Vector3d u = point.at(s_);
        const int link = static_cast<int>(l);
        visit(point.mass, Vector3d(poses_[0].origin(link) + poses_[0].rotation(link) * u),
              Vector3d(poses_[1].origin(link) + poses_[1].rotation(link) * u));
      }
  }

  test::Puppy puppy_;
  Ancestry ancestry_;
  VectorXd s_;
  GeometryAtDesign geometry_;
  PoseKinematics poses_[2];
  Columns columns_;
};

TEST_F(PuppyAtTwoPoses, SweptMomentumIsTheSumOverPoints) {
  Vector3d expected = Vector3d::Zero();
  for_each_point(
      [&](double mass, const Vector3d& p, const Vector3d& q) { expected += mass * p.cross(q); });
  PairMoments moments;
  moments.compute(puppy_.morphology, poses_[0], poses_[1]);
  PairDerivatives pair;
  pair.compute_swept_momentum(geometry_, ancestry_, 0, moments, poses_[0], poses_[1], columns_,
                              columns_);
  EXPECT_LT((pair.value - expected).norm(), 1e-14);
  EXPECT_GT(expected.norm(), 1e-3);
}

TEST_F(PuppyAtTwoPoses, ComIsTheSumOverPoints) {
  Vector3d sum = Vector3d::Zero();
  for_each_point([&](double mass, const Vector3d& p, const Vector3d&) { sum += mass * p; });
  PointDerivatives com;
  com_from_pose(geometry_, ancestry_, poses_[0], columns_, com);
  EXPECT_LT((com.value - sum / puppy_.morphology.total_mass()).norm(), 1e-14);
}

TEST_F(PuppyAtTwoPoses, FootTurnIsTheRotationVectorToSecondOrder) {
  PairDerivatives pair;
  pair.compute_foot_turn(puppy_.morphology, ancestry_, 2, poses_[0], poses_[1], columns_, columns_);
  const int link = puppy_.morphology.feet[2].link;
  const Eigen::AngleAxisd turn(
      Eigen::Matrix3d(poses_[1].rotation(link) * poses_[0].rotation(link).transpose()));
  EXPECT_LT((pair.value - std::sin(turn.angle()) * turn.axis()).norm(), 1e-12);
}

TEST_F(PuppyAtTwoPoses, MovedRobotIsTheSameRobotElsewhere) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d shift(0.3, -0.2, 0.0);
  PoseKinematics moved;
  moved.assign_moved(poses_[0], geometry_, turn, shift);
  PointDerivatives here, there;
  foot_from_pose(puppy_.morphology, geometry_, ancestry_, poses_[0], 1, columns_, here);
  foot_from_pose(puppy_.morphology, geometry_, ancestry_, moved, 1, columns_, there);
  EXPECT_LT((there.value - (turn * here.value + shift)).norm(), 1e-14);
  ASSERT_EQ(here.effects.size(), there.effects.size());
  for (std::size_t k = 0; k < here.effects.size(); ++k)
    EXPECT_LT((there.effects[k].rate - turn * here.effects[k].rate).norm(), 1e-13);
}

TEST(AxisAtDesign, DerivativesMatchDifferences) {
  const JointAxis axis{Vector3d::UnitY(), {{0, Vector3d::UnitZ()}, {1, Vector3d::UnitX()}}};
  const VectorXd s = (VectorXd(2) << 0.4, -0.7).finished();
  const AxisAtDesign at = axis_at(axis, s);
  EXPECT_LT((at.axis - axis.at(s)).norm(), 1e-15);
  EXPECT_NEAR(at.axis.norm(), 1.0, 1e-15);
  const double h = 1e-5;
  for (int k = 0; k < 2; ++k) {
    const VectorXd e = h * VectorXd::Unit(2, k);
    EXPECT_LT((at.first[k] - (axis.at(s + e) - axis.at(s - e)) / (2 * h)).norm(), 1e-9);
    for (int l = 0; l < 2; ++l)
      EXPECT_LT((at.second[k][l] -
                 (axis_at(axis, s + e).first[l] - axis_at(axis, s - e).first[l]) / (2 * h))
                    .norm(),
                1e-9);
  }
}

}  // namespace
}  // namespace legwright
