// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/lbfgs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::vector<bool> all_free(4, true);

MatrixXd curvature() {
  MatrixXd a = Eigen::Vector4d(1.0, 3.0, 5.0, 9.0).asDiagonal();
  a(0, 1) = a(1, 0) = 0.5;
  a(2, 3) = a(3, 2) = -1.0;
  return a;
}

TEST(Lbfgs, WithoutPairsItIsSteepestDescentInUnits) {
  const VectorXd scale = Eigen::Vector4d(0.1, 1.0, 2.0, 1.0);
  const Lbfgs lbfgs(scale, 5);
  const VectorXd gradient = Eigen::Vector4d(1.0, -2.0, 3.0, 0.0);
  EXPECT_LT((lbfgs.direction(gradient, all_free) + gradient.cwiseProduct(scale.cwiseAbs2())).norm(),
            1e-15);
}

TEST(Lbfgs, SatisfiesTheSecantConditionOfTheNewestPair) {
  Lbfgs lbfgs(Eigen::Vector4d(0.1, 1.0, 2.0, 1.0), 5);
  const MatrixXd a = curvature();
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(lbfgs.add(VectorXd::Unit(4, k), a.col(k)));
  const VectorXd direction = lbfgs.direction(a.col(2), all_free);  // B⁻¹y = s
  EXPECT_LT((direction + VectorXd::Unit(4, 2)).norm(), 1e-13);
}

TEST(Lbfgs, ReachesTheMinimumOfAQuadraticInFewSteps) {
  const MatrixXd a = curvature();
  VectorXd s = Eigen::Vector4d(1.0, -1.0, 2.0, 0.5), gradient = a * s;
  Lbfgs lbfgs(VectorXd::Ones(4), 10);
  int steps = 0;
  for (; gradient.norm() > 1e-10 && steps < 20; ++steps) {
    const VectorXd direction = lbfgs.direction(gradient, all_free);
    const VectorXd step = -gradient.dot(direction) / direction.dot(a * direction) * direction;
    s += step;
    ASSERT_TRUE(lbfgs.add(step, a * step));
    gradient = a * s;
  }
  EXPECT_LE(steps, 5);  // four, by conjugacy, and one for rounding
}

TEST(Lbfgs, UnitsOfTheParametersDoNotChangeThePath) {
  const VectorXd scale = Eigen::Vector4d(0.25, 1.0, 8.0, 2.0), ones = VectorXd::Ones(4);
  Lbfgs plain(ones, 5), scaled(scale, 5);
  const MatrixXd a = curvature();
  for (int k = 0; k < 3; ++k) {
    ASSERT_TRUE(plain.add(VectorXd::Unit(4, k), a.col(k)));
    ASSERT_TRUE(
        scaled.add(VectorXd::Unit(4, k).cwiseProduct(scale), a.col(k).cwiseQuotient(scale)));
  }
  const VectorXd gradient = Eigen::Vector4d(1.0, -2.0, 3.0, 0.5);
  const VectorXd expected = plain.direction(gradient, all_free).cwiseProduct(scale);
  EXPECT_LT((scaled.direction(gradient.cwiseQuotient(scale), all_free) - expected).norm(), 1e-14);
}

TEST(Lbfgs, KeepsOutPairsWithoutPositiveCurvature) {
  Lbfgs lbfgs(VectorXd::Ones(4), 5);
  const VectorXd e = VectorXd::Unit(4, 1);
  EXPECT_FALSE(lbfgs.add(e, -e));
  EXPECT_FALSE(lbfgs.add(e, VectorXd::Unit(4, 2)));
  EXPECT_FALSE(lbfgs.add(VectorXd::Zero(4), VectorXd::Zero(4)));
  EXPECT_FALSE(lbfgs.add(e, VectorXd::Constant(4, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_FALSE(lbfgs.add(e, VectorXd::Constant(4, std::numeric_limits<double>::infinity())));
  EXPECT_EQ(lbfgs.pair_count(), 0);
  EXPECT_TRUE(lbfgs.add(e, e));
  EXPECT_EQ(lbfgs.pair_count(), 1);
}

TEST(Lbfgs, HistoryIsBoundedAndTheOldestGoesFirst) {
  Lbfgs lbfgs(VectorXd::Ones(4), 2);
  const MatrixXd a = curvature();
  for (int k = 0; k < 4; ++k) ASSERT_TRUE(lbfgs.add(VectorXd::Unit(4, k), a.col(k)));
  EXPECT_EQ(lbfgs.pair_count(), 2);
  Lbfgs newest(VectorXd::Ones(4), 2);
  for (int k = 2; k < 4; ++k) ASSERT_TRUE(newest.add(VectorXd::Unit(4, k), a.col(k)));
  const VectorXd gradient = VectorXd::Ones(4);
  EXPECT_EQ(lbfgs.direction(gradient, all_free), newest.direction(gradient, all_free));
  lbfgs.reset();
  EXPECT_EQ(lbfgs.direction(gradient, all_free), -gradient);
}

TEST(Lbfgs, HeldParametersStayAndTheRestStillDescends) {
  Lbfgs lbfgs(VectorXd::Ones(4), 5);
  const MatrixXd a = curvature();
  for (int k = 0; k < 3; ++k)
    ASSERT_TRUE(lbfgs.add(VectorXd::Constant(4, 0.3) + VectorXd::Unit(4, k),
                          a * (VectorXd::Constant(4, 0.3) + VectorXd::Unit(4, k))));
  const VectorXd gradient = Eigen::Vector4d(5.0, -2.0, 3.0, 1.0);
  const VectorXd direction = lbfgs.direction(gradient, {false, true, true, false});
  EXPECT_EQ(direction[0], 0.0);
  EXPECT_EQ(direction[3], 0.0);
  EXPECT_LT(direction.dot(gradient), 0.0);
}

TEST(Bounds, OnlyParametersPushedOutwardsAreHeld) {
  const VectorXd lower = VectorXd::Zero(4), upper = VectorXd::Ones(4),
                 s = Eigen::Vector4d(0.0, 0.0, 1.0, 0.5);
  const VectorXd gradient = Eigen::Vector4d(4.0, -3.0, -2.0, 1.0);
  EXPECT_EQ(free_parameters(s, gradient, lower, upper),
            (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(projected_gradient_norm(s, gradient, lower, upper, VectorXd::Ones(4)), 3.0);
  EXPECT_EQ(projected_gradient_norm(s, gradient, lower, upper, Eigen::Vector4d(1.0, 0.1, 1.0, 1.0)),
            1.0);
}

TEST(Lbfgs, FrozenParametersAreHeldWhereverTheGradientPoints) {
  const VectorXd s = VectorXd::Ones(2), upper = Eigen::Vector2d(1.0, 2.0);
  const VectorXd lower = Eigen::Vector2d(1.0, 0.0);
  for (const double gradient : {-1.0, 0.0, 1.0}) {
    const std::vector<bool> free = free_parameters(s, Eigen::Vector2d(gradient, 1.0), lower, upper);
    EXPECT_FALSE(free[0]) << gradient;
    EXPECT_TRUE(free[1]);
  }
}

}  // namespace
}  // namespace legwright
