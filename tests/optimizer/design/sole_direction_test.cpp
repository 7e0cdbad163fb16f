// SPDX-License-Identifier: Apache-2.0
// Where a sole points, its slopes and curvatures along pose and design, against central
// differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "optimizer/design/kinematics.hpp"
#include "tests/support/flat_biped.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

class SoleDirection : public testing::Test {
 protected:
  SoleDirection() : ancestry_(robot_) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const VectorXd s = biped_.space.initial();
    at_.resize(robot_.pose_size() + s.size());
    for (double& value : at_) value = 0.4 * normal(random);
    at_.tail(s.size()) = s;
    at_[shank()] += 0.03;
    for (int k = 1; k < s.size(); ++k) at_[shank() + k] += 0.3 * normal(random);
    for (double& value : multiplier_) value = normal(random);
    for (Eigen::Index k = 0; k < at_.size(); ++k) columns_.push_back(static_cast<int>(k));
  }
  int shank() const { return robot_.pose_size(); }  // first of the design
  PoseKinematics pose(const VectorXd& at, PoseDetail detail = PoseDetail::design) const {
    PoseKinematics out;
    out.compute(robot_, GeometryAtDesign(robot_, at.tail(biped_.space.size())),
                at.head(robot_.pose_size()), detail);
    return out;
  }
  const Vector3d& own(int which) const {
    const Sole& sole = *robot_.feet[0].sole;
    return which == 0 ? sole.ahead : sole.beside;
  }
  PointDerivatives direction(const VectorXd& at, int which) const {
    PointDerivatives out;
    direction_from_pose(ancestry_, pose(at), robot_.feet[0].link, own(which), columns_, out);
    return out;
  }
  MatrixXd jacobian(const VectorXd& at, int which) const {
    MatrixXd out = MatrixXd::Zero(at_.size(), 3);
    direction(at, which).add_jacobian(out);
    return out;
  }
  /// ∂/∂column of what `value` gives at a point, a column each.
  template <class Value>
  MatrixXd differences(Value value) const {
    MatrixXd out;
    for (Eigen::Index k = 0; k < at_.size(); ++k) {
      VectorXd up = at_, down = at_;
      up[k] += 1e-5;
      down[k] -= 1e-5;
      const VectorXd slope = (value(up) - value(down)) / 2e-5;
      out.conservativeResize(slope.size(), k + 1);
      out.col(k) = slope;
    }
    return out;
  }

  const test::Puppy biped_ = test::make_flat_biped(0.2);
  const Morphology& robot_ = biped_.morphology;
  Ancestry ancestry_;
  VectorXd at_;
  Vector3d multiplier_;
  Columns columns_;
};

TEST_F(SoleDirection, IsAUnitVectorThatTurnsWithItsLink) {
  for (int which = 0; which < 2; ++which) {
    const Vector3d value = direction(at_, which).value;
    EXPECT_NEAR(value.norm(), 1.0, 1e-12);
    EXPECT_LT((value - pose(at_).rotation(robot_.feet[0].link) * own(which)).norm(), 1e-15);
  }
  EXPECT_NEAR(direction(at_, 0).value.dot(direction(at_, 1).value), 0.0, 1e-12);
}

TEST_F(SoleDirection, SlopesMatchDifferences) {
  for (int which = 0; which < 2; ++which) {
    const MatrixXd exact = jacobian(at_, which).transpose();
    const MatrixXd numeric =
        differences([&](const VectorXd& at) -> VectorXd { return direction(at, which).value; });
    EXPECT_LT((exact - numeric).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT((1.0001 * exact - numeric).cwiseAbs().maxCoeff(), 1e-6);  // poison is noticed
  }
}

TEST_F(SoleDirection, CurvatureMatchesDifferences) {
  for (int which = 0; which < 2; ++which) {
    MatrixXd lower = MatrixXd::Zero(at_.size(), at_.size());
    direction(at_, which).add_curvature(ancestry_, multiplier_, lower);
    const MatrixXd exact = lower.selfadjointView<Eigen::Lower>();
    const MatrixXd numeric = differences(
        [&](const VectorXd& at) -> VectorXd { return jacobian(at, which) * multiplier_; });
    EXPECT_LT((exact - numeric).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_GT((1.0001 * exact - numeric).cwiseAbs().maxCoeff(), 1e-6);
    const Eigen::Index axes = biped_.space.size() - 1;  // all that is not a length
    EXPECT_GT(exact.bottomRightCorner(axes, axes).cwiseAbs().maxCoeff(), 0.1);
  }
}

/// Neither lengths nor places of the root, nor the other leg; turned axes do.
TEST_F(SoleDirection, KnowsWhatMovesIt) {
  const MatrixXd slopes = jacobian(at_, 0);
  EXPECT_EQ(slopes.topRows<3>().norm(), 0.0);
  EXPECT_EQ(slopes.row(shank()).norm(), 0.0);
  EXPECT_EQ(slopes.middleRows<6>(6 + 6).norm(), 0.0);
  for (int k = 0; k < 6; ++k) EXPECT_GT(slopes.row(6 + k).norm(), 0.01) << "hinge " << k;
  for (int k = 1; k < biped_.space.size(); ++k) EXPECT_GT(slopes.row(shank() + k).norm(), 0.01);
}

TEST_F(SoleDirection, LeavesTheDesignOutWhereItIsNotAskedFor) {
  Columns motion(columns_.begin(), columns_.begin() + robot_.pose_size());
  motion.resize(columns_.size(), -1);
  PointDerivatives out;
  direction_from_pose(ancestry_, pose(at_, PoseDetail::motion), robot_.feet[0].link, own(0), motion,
                      out);
  for (const PointDerivatives::Effect& effect : out.effects) EXPECT_GE(effect.column, 0);
  for (const PointDerivatives::Second& second : out.seconds)
    EXPECT_GE(std::min(second.a, second.b), 0);
}

}  // namespace
}  // namespace legwright
