// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/optimizer/solve/toy_cost.hpp"
#include "tests/support/not_finite.hpp"

namespace legwright {
namespace {

using test::kNan;

using Eigen::MatrixXd;
using Eigen::VectorXd;
using toy::MotionFunction;
using Derivatives = MotionFunction::Derivatives;

/// Σ 100 (x_{i+1} − x_i²)² + (1 − x_i)²: a curved valley with stiff walls, like a penalty.
Derivatives rosenbrock(const VectorXd& x) {
  const int n = static_cast<int>(x.size());
  Derivatives d{0.0, VectorXd::Zero(n), MatrixXd::Zero(n, n)};
  for (int i = 0; i + 1 < n; ++i) {
    const double wall = x[i + 1] - x[i] * x[i], slack = 1.0 - x[i];
    d.value += 100.0 * wall * wall + slack * slack;
    d.gradient[i] += -400.0 * wall * x[i] - 2.0 * slack;
    d.gradient[i + 1] += 200.0 * wall;
    d.hessian(i, i) += 1200.0 * x[i] * x[i] - 400.0 * x[i + 1] + 2.0;
    d.hessian(i + 1, i + 1) += 200.0;
    d.hessian(i + 1, i) += -400.0 * x[i];
    d.hessian(i, i + 1) += -400.0 * x[i];
  }
  return d;
}

/// c·x − μ Σ log x, infinite outside: minimum at μ/c.
Derivatives barrier(const VectorXd& x) {
  const double mu = 1e-3;
  const VectorXd cost = VectorXd::LinSpaced(x.size(), 1.0, 3.0);
  Derivatives d{cost.dot(x), cost, MatrixXd::Zero(x.size(), x.size())};
  for (int i = 0; i < x.size(); ++i) {
    d.value -= x[i] > 0.0 ? mu * std::log(x[i]) : -std::numeric_limits<double>::infinity();
    d.gradient[i] -= mu / x[i];
    d.hessian(i, i) = mu / (x[i] * x[i]);
  }
  return d;
}

/// Σ ¼x⁴ − ½x² plus a coupling: indefinite around the start, minima away from it.
Derivatives double_well(const VectorXd& x) {
  const int n = static_cast<int>(x.size());
  Derivatives d{0.0, VectorXd::Zero(n), MatrixXd::Zero(n, n)};
  for (int i = 0; i < n; ++i) {
    const double u = x[i];
    d.value += 0.25 * u * u * u * u - 0.5 * u * u;
    d.gradient[i] += u * u * u - u;
    d.hessian(i, i) += 3.0 * u * u - 1.0;
    if (i + 1 == n) continue;
    const double stretch = x[i + 1] - u;
    d.value += 0.05 * stretch * stretch;
    d.gradient[i] -= 0.1 * stretch;
    d.gradient[i + 1] += 0.1 * stretch;
    d.hessian(i, i) += 0.1;
    d.hessian(i + 1, i + 1) += 0.1;
    d.hessian(i + 1, i) -= 0.1;
    d.hessian(i, i + 1) -= 0.1;
  }
  return d;
}

/// The double well in variables of units 1e-3 … 1e3.
struct BadlyScaled {
  VectorXd units;
  Derivatives operator()(const VectorXd& x) const {
    Derivatives d = double_well(x.cwiseQuotient(units));
    d.gradient = d.gradient.cwiseQuotient(units);
    d.hessian = units.cwiseInverse().asDiagonal() * d.hessian * units.cwiseInverse().asDiagonal();
    return d;
  }
};

SolveReport solve(MotionFunction& function, VectorXd& m,
                  NewtonOptions options = {.tolerance = 1e-8}) {
  NewtonWorkspace workspace;
  return newton(function, VectorXd(), m, options, workspace);
}

TEST(Newton, QuadraticTakesOneStepAndTwoFactors) {
  const VectorXd ones = VectorXd::Ones(4);
  MotionFunction bowl(
      [&](const VectorXd& x) {
        return Derivatives{0.5 * (x - ones).squaredNorm(), x - ones, MatrixXd::Identity(4, 4)};
      },
      ones);
  VectorXd m = VectorXd::Zero(4);
  const SolveReport report = solve(bowl, m);
  EXPECT_EQ(report.status, SolveStatus::converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.factorisations, 2);  // the step and the certificate
  EXPECT_TRUE(report.exact_factor);
  EXPECT_EQ(report.evaluations, bowl.calls);
  EXPECT_EQ(m, ones);
}

TEST(Newton, FollowsAStiffCurvedValley) {
  VectorXd m = VectorXd::Constant(20, -1.2);
  MotionFunction valley(rosenbrock, VectorXd::Ones(20));
  const SolveReport report = solve(valley, m);
  EXPECT_EQ(report.status, SolveStatus::converged);
  EXPECT_LT((m - VectorXd::Ones(20)).norm(), 1e-6);
  EXPECT_LT(report.factorisations, 80);
}

/// Kinematics in small: reach a far point at length 1 from the origin, ½|x − p|² + ½·1e4 (|x|² −
/// 1)².
Derivatives arm(const VectorXd& x) {
  const Eigen::Vector2d target(2.0, 0.5);
  const double stretch = x.squaredNorm() - 1.0, weight = 1e4;
  const MatrixXd one = MatrixXd::Identity(2, 2);
  return {0.5 * (x - target).squaredNorm() + 0.5 * weight * stretch * stretch,
          x - target + 2.0 * weight * stretch * x,
          one + 2.0 * weight * stretch * one + 4.0 * weight * x * x.transpose()};
}

TEST(Newton, CorrectionsFollowAStiffPenaltyWithFewerFactors) {
  int factorisations[2];
  for (const int corrections : {0, 6}) {
    VectorXd m = Eigen::Vector2d(-0.6, 0.8);
    MotionFunction circle(arm, VectorXd::Ones(2));
    const SolveReport report = solve(circle, m, {.tolerance = 1e-6, .corrections = corrections});
    ASSERT_EQ(report.status, SolveStatus::converged);
    EXPECT_NEAR(m.norm(), 1.0, 1e-4);
    EXPECT_NEAR(m[1] / m[0], 0.25, 1e-4);
    factorisations[corrections > 0] = report.factorisations;
  }
  EXPECT_LT(factorisations[1], factorisations[0]);
}

TEST(Newton, StaysInsideABarrier) {
  VectorXd m = VectorXd::Constant(6, 1.0);
  MotionFunction walls(barrier, VectorXd::Ones(6));
  const SolveReport report = solve(walls, m);
  EXPECT_EQ(report.status, SolveStatus::converged);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(m[i], 1e-3 / (1.0 + 0.4 * i), 1e-8);
}

TEST(Newton, LeavesAnIndefiniteStartDownwards) {
  VectorXd m = VectorXd::LinSpaced(10, -0.1, 0.12);
  MotionFunction wells(double_well, VectorXd::Ones(10));
  const double before = double_well(m).value;
  const SolveReport report = solve(wells, m);
  EXPECT_EQ(report.status, SolveStatus::converged);
  EXPECT_LT(report.value, before - 1.0);
  EXPECT_GT(report.shifted_steps, 0);
  EXPECT_LT(report.factorisations, 40);
}

TEST(Newton, UnitsDoNotMatterUnlessTheyAreWithheld) {
  const VectorXd start = VectorXd::LinSpaced(10, -0.1, 0.12);
  VectorXd m = start;
  MotionFunction wells(double_well, VectorXd::Ones(10));
  const SolveReport plain = solve(wells, m);

  VectorXd units(10);
  for (int i = 0; i < 10; ++i) units[i] = std::ldexp(1.0, 2 * i - 9);  // exact in binary: same path
  VectorXd scaled = start.cwiseProduct(units);
  MotionFunction twisted(BadlyScaled{units}, units);
  const SolveReport report = solve(twisted, scaled);
  EXPECT_EQ(report.status, SolveStatus::converged);
  EXPECT_EQ(report.iterations, plain.iterations);
  EXPECT_LT((scaled.cwiseQuotient(units) - m).norm(), 1e-8);

  VectorXd blind = start.cwiseProduct(units);
  MotionFunction unscaled(BadlyScaled{units}, VectorXd::Ones(10));
  const SolveReport slow = solve(unscaled, blind);
  EXPECT_GT(slow.factorisations, report.factorisations);
}

TEST(Newton, ASaddleIsNotConverged) {
  VectorXd m = VectorXd::Zero(2);
  MotionFunction saddle(
      [](const VectorXd& x) {
        MatrixXd h = Eigen::Vector2d(1.0, -1.0).asDiagonal();
        return Derivatives{0.5 * x.dot(h * x), h * x, h};
      },
      VectorXd::Ones(2));
  EXPECT_EQ(solve(saddle, m).status, SolveStatus::not_a_minimum);
}

TEST(Newton, ANullDirectionIsNotConverged) {
  VectorXd m = Eigen::Vector2d(3.0, 5.0);
  MotionFunction trough(
      [](const VectorXd& x) {
        MatrixXd h = Eigen::Vector2d(1.0, 0.0).asDiagonal();
        return Derivatives{0.5 * x.dot(h * x), h * x, h};
      },
      VectorXd::Ones(2));
  const SolveReport report = solve(trough, m);
  EXPECT_EQ(report.status, SolveStatus::not_a_minimum);
  EXPECT_LT(std::abs(m[0]), 1e-8);
  EXPECT_EQ(m[1], 5.0);
}

TEST(Newton, NoMinimumEndsAtALimit) {
  VectorXd m = VectorXd::Ones(3);
  MotionFunction slope(
      [](const VectorXd& x) {
        return Derivatives{-x.sum(), -VectorXd::Ones(x.size()), MatrixXd::Zero(3, 3)};
      },
      VectorXd::Ones(3));
  const SolveReport report = solve(slope, m, {.max_iterations = 15});
  EXPECT_EQ(report.status, SolveStatus::iteration_limit);
  EXPECT_TRUE(m.allFinite());
}

TEST(Newton, AWrongGradientStallsAtTheBestIterate) {
  const VectorXd start = VectorXd::Constant(3, 2.0);
  VectorXd m = start;
  MotionFunction liar(
      [](const VectorXd& x) {
        return Derivatives{0.5 * x.squaredNorm(), -x, MatrixXd::Identity(3, 3)};
      },
      VectorXd::Ones(3));
  const SolveReport report = solve(liar, m);
  EXPECT_EQ(report.status, SolveStatus::stalled);
  EXPECT_EQ(m, start);
  EXPECT_LE(report.factorisations, 12);
}

// Whatever turns to NaN, and whenever: never `converged` beside it, and the iterate is one that was
// finite.
TEST(Newton, NaNAtAnyCallIsNeverConverged) {
  enum { value, gradient, hessian, part_count };
  VectorXd reference = VectorXd::Constant(5, -1.2);
  MotionFunction clean(rosenbrock, VectorXd::Ones(5));
  ASSERT_EQ(solve(clean, reference).status, SolveStatus::converged);
  for (int part = 0; part < part_count; ++part) {
    for (const bool for_ever : {false, true}) {
      for (int k = 1; k <= clean.calls; ++k) {
        int call = 0;
        MotionFunction poisoned(
            [&](const VectorXd& x) {
              Derivatives d = rosenbrock(x);
              ++call;
              if (for_ever ? call < k : call != k) return d;
              if (part == value) d.value = kNan;
              if (part == gradient) d.gradient[2] = kNan;
              if (part == hessian) d.hessian(3, 2) = kNan;
              return d;
            },
            VectorXd::Ones(5));
        VectorXd m = VectorXd::Constant(5, -1.2);
        const SolveReport report = solve(poisoned, m);
        ASSERT_TRUE(m.allFinite());
        if (k == 1) {
          EXPECT_EQ(report.status, SolveStatus::not_finite);
        }
        if (report.status == SolveStatus::converged) {
          EXPECT_TRUE(std::isfinite(report.value) && std::isfinite(report.stationarity));
          EXPECT_LT((m - VectorXd::Ones(5)).norm(), 1e-6) << "part " << part << " call " << k;
        }
        if (k > 1) {
          EXPECT_EQ(report.value, rosenbrock(m).value) << "the report belongs to the iterate";
        }
      }
    }
  }
}

TEST(Newton, LeavesATrialThatWillStayAboveTheCeilingEarly) {
  VectorXd full = VectorXd::Constant(20, -1.2), cut = full;
  MotionFunction valley(rosenbrock, VectorXd::Ones(20));
  const SolveReport whole = solve(valley, full);
  const SolveReport left = solve(valley, cut, {.tolerance = 1e-8, .value_ceiling = -1e9});
  EXPECT_EQ(left.status, SolveStatus::stopped);
  EXPECT_LT(left.iterations, whole.iterations / 2);
}

TEST(Newton, AsksBeforeEachStepWhetherToGoOn) {
  VectorXd m = VectorXd::Constant(20, -1.2);
  MotionFunction valley(rosenbrock, VectorXd::Ones(20));
  int asked = 0;
  const SolveReport report =
      solve(valley, m, {.tolerance = 1e-8, .go_on = [&] { return ++asked < 3; }});
  EXPECT_EQ(report.status, SolveStatus::stopped);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_EQ(asked, 3);
}

TEST(Newton, StagnationIsALimitNotConvergence) {
  VectorXd m = VectorXd::Constant(20, -1.2);
  MotionFunction valley(rosenbrock, VectorXd::Ones(20));
  const SolveReport report =
      solve(valley, m, {.tolerance = 1e-8, .stagnation_window = 3, .stagnation_decrease = 0.9});
  EXPECT_EQ(report.status, SolveStatus::iteration_limit);
  EXPECT_TRUE(report.stagnated);
}

TEST(Newton, SameBitsTwiceWithAWorkspaceUsedBefore) {
  NewtonWorkspace used;
  MotionFunction wells(double_well, VectorXd::Ones(10)), valley(rosenbrock, VectorXd::Ones(10));
  VectorXd other = VectorXd::LinSpaced(10, -0.1, 0.12);
  (void)newton(wells, VectorXd(), other, {}, used);
  VectorXd a = VectorXd::Constant(10, -1.2), b = a;
  const SolveReport first = newton(valley, VectorXd(), a, {}, used), second = solve(valley, b, {});
  EXPECT_EQ(a, b);
  EXPECT_EQ(first.value, second.value);
  EXPECT_EQ(first.factorisations, second.factorisations);
}

}  // namespace
}  // namespace legwright
