// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/adjoint.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "optimizer/solve/newton.hpp"
#include "tests/optimizer/solve/toy_cost.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using toy::kDesignSize;
using toy::kMotionSize;

/// A cost that is not F: J = ½‖m − t‖² + mᵀEs + sin(s₀).
struct ForeignCost {
  VectorXd target = VectorXd::LinSpaced(kMotionSize, -1.0, 2.0);
  MatrixXd coupling = MatrixXd::Constant(kMotionSize, kDesignSize, 0.3);

  double value(const VectorXd& s, const VectorXd& m) const {
    return 0.5 * (m - target).squaredNorm() + m.dot(coupling * s) + std::sin(s[0]);
  }
  VectorXd dm(const VectorXd& s, const VectorXd& m) const { return m - target + coupling * s; }
  VectorXd ds(const VectorXd& s, const VectorXd& m) const {
    VectorXd d = coupling.transpose() * m;
    d[0] += std::cos(s[0]);
    return d;
  }
};

/// The point on G(s, ·) = level next to m: what eq (4) follows. level 0 is the motion optimum.
VectorXd resolve(toy::CoupledCost& cost, const VectorXd& s, VectorXd m, const VectorXd& level) {
  Evaluation e;
  for (int k = 0; k < 50; ++k) {
    cost.evaluate(s, m, Order::hessian, e);
    const MatrixXd full = MatrixXd(e.hessian_mm).selfadjointView<Eigen::Lower>();
    m -= full.ldlt().solve(e.stationarity - level);
  }
  return m;
}

/// Largest relative error of `gradient` against central differences of J over re-solved motions.
double error_of(const VectorXd& gradient, toy::CoupledCost& cost, const ForeignCost& J,
                const VectorXd& s, const VectorXd& m, const VectorXd& level) {
  VectorXd expected(kDesignSize);
  const double h = 1e-5;
  for (int k = 0; k < kDesignSize; ++k) {
    VectorXd ahead = s, behind = s;
    ahead[k] += h;
    behind[k] -= h;
    expected[k] = (J.value(ahead, resolve(cost, ahead, m, level)) -
                   J.value(behind, resolve(cost, behind, m, level))) /
                  (2 * h);
  }
  return (gradient - expected).norm() / expected.norm();
}

struct Point {
  toy::CoupledCost cost{kMotionSize, kDesignSize};
  VectorXd s = Eigen::Vector4d(0.4, -0.7, 0.9, 0.2), m;
  Evaluation at;
  HessianFactor factor;

  explicit Point(bool converged) {
    m = VectorXd::LinSpaced(kMotionSize, 0.5, -0.8);
    if (converged) m = resolve(cost, s, m, VectorXd::Zero(kMotionSize));
    cost.evaluate(s, m, Order::design, at);
  }
};

TEST(Adjoint, MatchesResolvedDifferenceForForeignCost) {
  Point p(true);
  const ForeignCost J;
  const AdjointResult result =
      adjoint(p.factor, p.at.hessian_mm, J.dm(p.s, p.m), p.at.hessian_ms, J.ds(p.s, p.m));
  ASSERT_EQ(result.status, SolveStatus::converged);
  EXPECT_LT(result.residual, 1e-13);
  const VectorXd level = VectorXd::Zero(kMotionSize);
  EXPECT_LT(error_of(result.dJ_ds, p.cost, J, p.s, p.m, level), 1e-8);

  // Twins that a careless test, with J = F at m*, would let pass.
  const VectorXd direct = J.ds(p.s, p.m), through = result.dJ_ds - direct;
  EXPECT_GT(error_of(direct - through, p.cost, J, p.s, p.m, level), 1e-2) << "wrong sign of λ";
  EXPECT_GT(error_of(direct + 2.0 * through, p.cost, J, p.s, p.m, level), 1e-2)
      << "wrong scale of λ";
  EXPECT_GT(error_of(direct, p.cost, J, p.s, p.m, level), 1e-2) << "no λ";
}

TEST(Adjoint, MatchesDifferenceAlongTheManifoldAtUnconvergedMotion) {
  Point p(false);
  ASSERT_GT(p.at.stationarity.norm(), 0.5);
  const ForeignCost J;
  const AdjointResult result =
      adjoint(p.factor, p.at.hessian_mm, J.dm(p.s, p.m), p.at.hessian_ms, J.ds(p.s, p.m));
  ASSERT_EQ(result.status, SolveStatus::converged);
  EXPECT_LT(error_of(result.dJ_ds, p.cost, J, p.s, p.m, p.at.stationarity), 1e-8);
}

TEST(Adjoint, AgreesWithForwardSensitivity) {  // eqs (4), (6)
  for (const bool converged : {true, false}) {
    Point p(converged);
    const ForeignCost J;
    const AdjointResult result =
        adjoint(p.factor, p.at.hessian_mm, J.dm(p.s, p.m), p.at.hessian_ms, J.ds(p.s, p.m));
    const MatrixXd full = MatrixXd(p.at.hessian_mm).selfadjointView<Eigen::Lower>();
    const MatrixXd sensitivity = -full.ldlt().solve(p.at.hessian_ms);
    const VectorXd forward = sensitivity.transpose() * J.dm(p.s, p.m) + J.ds(p.s, p.m);
    EXPECT_LT((result.dJ_ds - forward).norm(), 1e-12 * forward.norm());
  }
}

TEST(Adjoint, LambdaIsTheNewtonStepForTheCostItself) {
  Point p(false);
  const AdjointResult result =
      adjoint(p.factor, p.at.hessian_mm, p.at.stationarity, p.at.hessian_ms, p.at.partial_s);
  const MatrixXd full = MatrixXd(p.at.hessian_mm).selfadjointView<Eigen::Lower>();
  EXPECT_LT((result.lambda + full.ldlt().solve(p.at.stationarity)).norm(), 1e-12);
}

TEST(Adjoint, IndefiniteHessianIsNotAMinimumAndHasNoGradient) {
  Point p(true);
  p.at.hessian_mm.coeffRef(2, 2) = -50.0;
  const AdjointResult result =
      adjoint(p.factor, p.at.hessian_mm, p.at.stationarity, p.at.hessian_ms, p.at.partial_s);
  EXPECT_EQ(result.status, SolveStatus::not_a_minimum);
  EXPECT_EQ(result.dJ_ds.size(), 0);
}

TEST(Adjoint, WhatIsNotFiniteIsNeverConverged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ForeignCost J;
  for (int input = 0; input < 4; ++input) {
    Point p(true);
    VectorXd dm = J.dm(p.s, p.m), ds = J.ds(p.s, p.m);
    if (input == 0) p.at.hessian_mm.coeffRef(3, 1) = nan;
    if (input == 1) dm[4] = nan;
    if (input == 2) p.at.hessian_ms(2, 1) = nan;
    if (input == 3) ds[0] = nan;
    const AdjointResult result = adjoint(p.factor, p.at.hessian_mm, dm, p.at.hessian_ms, ds);
    EXPECT_NE(result.status, SolveStatus::converged) << "input " << input;
    EXPECT_EQ(result.dJ_ds.size(), 0);
  }
}

}  // namespace
}  // namespace legwright
