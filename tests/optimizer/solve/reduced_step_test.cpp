// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/reduced_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

DesignBox box(int n, double half) {
  return {VectorXd::Constant(n, -half), VectorXd::Constant(n, half), VectorXd::Ones(n)};
}

MatrixXd convex(int n) {
  MatrixXd h = MatrixXd::Constant(n, n, 0.3);
  h.diagonal() = VectorXd::LinSpaced(n, 1.0, 4.0);
  return h;
}

TEST(ReducedNewtonStep, IsNewtonsWhereNothingIsInTheWay) {
  const MatrixXd h = convex(4);
  const VectorXd g = VectorXd::LinSpaced(4, -0.5, 0.7), s = VectorXd::Zero(4);
  const VectorXd step = reduced_newton_step(h, g, s, box(4, 10.0), 10.0);
  EXPECT_LT((h * step + g).norm(), 1e-12);
}

TEST(ReducedNewtonStep, DoesNotDependOnUnits) {
  const MatrixXd h = convex(3);
  const VectorXd g = VectorXd::LinSpaced(3, -0.5, 0.7), s = VectorXd::Zero(3);
  const VectorXd plain = reduced_newton_step(h, g, s, box(3, 10.0), 0.1);
  const VectorXd unit(VectorXd::LinSpaced(3, 0.01, 100.0));
  DesignBox scaled = box(3, 10.0);
  scaled.scale = unit;
  scaled.lower = scaled.lower.cwiseProduct(unit);
  scaled.upper = scaled.upper.cwiseProduct(unit);
  const MatrixXd h_scaled = unit.cwiseInverse().asDiagonal() * h * unit.cwiseInverse().asDiagonal();
  const VectorXd step = reduced_newton_step(h_scaled, g.cwiseQuotient(unit), s, scaled, 0.1);
  EXPECT_LT((step.cwiseQuotient(unit) - plain).norm(), 1e-12);
}

TEST(ReducedNewtonStep, MinimisesOverTheRestWhereABoundIsHit) {
  const MatrixXd h = convex(3);
  const VectorXd g(VectorXd::Constant(3, -2.0)), s = VectorXd::Zero(3);
  DesignBox narrow = box(3, 10.0);
  narrow.upper[0] = 0.2;
  const VectorXd step = reduced_newton_step(h, g, s, narrow, 10.0);
  EXPECT_DOUBLE_EQ(step[0], 0.2);
  const VectorXd rest = h * step + g;
  EXPECT_LT(rest[0], 0.0) << "pushes on against the bound";
  EXPECT_LT(rest.tail(2).norm(), 1e-12);
}

TEST(ReducedNewtonStep, LeavesAloneWhatPushesAgainstItsBound) {
  const VectorXd g = VectorXd::Constant(2, -1.0);
  const VectorXd s = box(2, 1.0).upper;
  EXPECT_EQ(reduced_newton_step(convex(2), g, s, box(2, 1.0), 1.0).norm(), 0.0);
}

TEST(ReducedNewtonStep, NeverFollowsNegativeCurvatureUphill) {
  MatrixXd h = convex(3);
  h(1, 1) = -2.0;
  const VectorXd g = VectorXd::LinSpaced(3, 0.3, -0.4), s = VectorXd::Zero(3);
  const VectorXd step = reduced_newton_step(h, g, s, box(3, 10.0), 0.25);
  EXPECT_LT(g.dot(step), 0.0);
  EXPECT_LE(step.lpNorm<Eigen::Infinity>(), 0.25);
  EXPECT_LT(model_change(h, g, step), 0.0);
}

TEST(ReducedNewtonStep, NothingWithoutFiniteNumbers) {
  MatrixXd h = convex(2);
  h(0, 1) = std::nan("");
  EXPECT_EQ(reduced_newton_step(h, VectorXd::Ones(2), VectorXd::Zero(2), box(2, 1.0), 1.0).norm(),
            0.0);
}

TEST(SteepestStep, IsTheModelsLeastAlongTheGradientWithinTheBox) {
  const MatrixXd h = convex(3);
  const VectorXd g(VectorXd::LinSpaced(3, -0.5, 0.7)), s = VectorXd::Zero(3);
  const VectorXd step = steepest_step(h, g, s, box(3, 10.0), 10.0);
  EXPECT_LT((step / step.norm() + g / g.norm()).norm(), 1e-12);
  EXPECT_NEAR(step.dot(h * step), -g.dot(step), 1e-12);  // the slope is gone at its end
  // Curved downwards it goes as far as it may.
  EXPECT_NEAR(steepest_step(-h, g, s, box(3, 10.0), 0.2).lpNorm<Eigen::Infinity>(), 0.2, 1e-15);
  DesignBox narrow = box(3, 10.0);
  narrow.lower[2] = 0.0;  // where the gradient pushes
  const VectorXd held = steepest_step(-h, 10.0 * g, s, narrow, 0.2);
  EXPECT_EQ(held[2], 0.0);
  EXPECT_NEAR(held.lpNorm<Eigen::Infinity>(), 0.2, 1e-15) << "what is held does not hold the rest";
  EXPECT_EQ(steepest_step(h, VectorXd::Zero(3), s, narrow, 0.2).norm(), 0.0);
}

}  // namespace
}  // namespace legwright
