// SPDX-License-Identifier: Apache-2.0
// Points of links as the trunk sees them: the same wherever the trunk is, and slopes and curvatures
// along joints and design against central differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/pose_gradient.hpp"
#include "tests/support/flat_biped.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

class TrunkPoint : public testing::Test {
 protected:
  TrunkPoint() : ancestry_(robot_) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const VectorXd s = biped_.space.initial();
    at_.resize(robot_.pose_size() + s.size());
    for (double& value : at_) value = 0.4 * normal(random);
    at_.tail(s.size()) = s;
    for (Eigen::Index k = 0; k < s.size(); ++k)
      at_[robot_.pose_size() + k] += 0.01 * normal(random);
    for (double& value : multiplier_) value = normal(random);
    // A column for each coordinate but the trunk's six, which must not be asked for.
    columns_.assign(static_cast<std::size_t>(at_.size()), -1);
    for (int k = 6; k < at_.size(); ++k) columns_[static_cast<std::size_t>(k)] = k - 6;
  }
  GeometryAtDesign geometry(const VectorXd& at) const {
    return GeometryAtDesign(robot_, at.tail(biped_.space.size()));
  }
  PoseKinematics pose(const VectorXd& at, PoseDetail detail = PoseDetail::design) const {
    PoseKinematics out;
    out.compute(robot_, geometry(at), at.head(robot_.pose_size()), detail);
    return out;
  }
  Vector3d place(const VectorXd& at, int foot) const {
    return place_from_trunk(pose(at), robot_.feet[foot].link, geometry(at).feet[foot]);
  }
  PointDerivatives derivatives(const VectorXd& at, int foot, PoseDetail detail) const {
    PointDerivatives out;
    point_from_trunk(robot_, ancestry_, pose(at, detail), robot_.feet[foot].link, place(at, foot),
                     robot_.feet[foot].position, columns_, out);
    return out;
  }
  MatrixXd jacobian(const VectorXd& at, int foot, PoseDetail detail = PoseDetail::design) const {
    MatrixXd out = MatrixXd::Zero(at_.size() - 6, 3);
    derivatives(at, foot, detail).add_jacobian(out);
    return out;
  }
  /// ∂/∂column of what `value` gives at a point, a column each.
  template <class Value>
  MatrixXd differences(Value value) const {
    MatrixXd out;
    for (Eigen::Index k = 6; k < at_.size(); ++k) {
      VectorXd up = at_, down = at_;
      up[k] += 1e-5;
      down[k] -= 1e-5;
      const VectorXd slope = (value(up) - value(down)) / 2e-5;
      out.conservativeResize(slope.size(), k - 5);
      out.col(k - 6) = slope;
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

TEST_F(TrunkPoint, IsWhereTheWorldHasItAndStaysWhereTheTrunkGoes) {
  for (int foot = 0; foot < robot_.foot_count(); ++foot) {
    const PoseKinematics here = pose(at_);
    const Vector3d world = foot_place(robot_, geometry(at_), here, foot);
    EXPECT_LT((here.rotation(0) * place(at_, foot) + here.origin(0) - world).norm(), 1e-14);
    VectorXd elsewhere = at_;
    elsewhere.head<6>() += 0.5 * VectorXd::LinSpaced(6, -1.0, 1.0);
    EXPECT_LT((place(elsewhere, foot) - place(at_, foot)).norm(), 1e-14);
    EXPECT_LT((jacobian(elsewhere, foot) - jacobian(at_, foot)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST_F(TrunkPoint, SlopesMatchDifferences) {
  for (int foot = 0; foot < robot_.foot_count(); ++foot) {
    const MatrixXd exact = jacobian(at_, foot).transpose();
    const MatrixXd numeric =
        differences([&](const VectorXd& at) -> VectorXd { return place(at, foot); });
    EXPECT_LT((exact - numeric).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT(exact.cwiseAbs().maxCoeff(), 0.05);
  }
}

TEST_F(TrunkPoint, CurvatureMatchesDifferences) {
  for (int foot = 0; foot < robot_.foot_count(); ++foot) {
    MatrixXd exact = MatrixXd::Zero(at_.size() - 6, at_.size() - 6);
    derivatives(at_, foot, PoseDetail::design).add_curvature(ancestry_, multiplier_, exact);
    const MatrixXd lower = exact.triangularView<Eigen::StrictlyLower>();
    exact += lower.transpose();
    const MatrixXd numeric = differences(
        [&](const VectorXd& at) -> VectorXd { return jacobian(at, foot) * multiplier_; });
    EXPECT_LT((exact - numeric).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT(exact.cwiseAbs().maxCoeff(), 0.05);
  }
}

TEST_F(TrunkPoint, GradientIsTheJacobianTimesTheMultiplierToTheBit) {
  for (int foot = 0; foot < robot_.foot_count(); ++foot) {
    VectorXd gradient = VectorXd::Zero(robot_.pose_size());
    add_trunk_point_gradient(robot_, pose(at_, PoseDetail::rates), robot_.feet[foot].link,
                             place(at_, foot), multiplier_, gradient.data());
    const MatrixXd J = jacobian(at_, foot, PoseDetail::motion);
    for (int joint = 0; joint < robot_.joint_count(); ++joint) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum = sum + J(joint, k) * multiplier_[k];
      EXPECT_EQ(gradient[6 + joint], sum) << joint;
    }
    EXPECT_EQ(gradient.head<6>(), VectorXd::Zero(6));
  }
}

TEST_F(TrunkPoint, APointOfTheTrunkFollowsItsDesignAlone) {
  const Vector3d own(0.1, -0.2, 0.3);
  EXPECT_EQ(place_from_trunk(pose(at_), 0, own), own);
}

}  // namespace
}  // namespace legwright
