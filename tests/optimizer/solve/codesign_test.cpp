// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/codesign.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "optimizer/solve/adjoint.hpp"
#include "tests/optimizer/solve/toy_cost.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int motion_size = 8, design_size = 4;

DesignSpace box(double half) {
  DesignSpace space;
  for (int k = 0; k < design_size; ++k) {
    DesignParameter parameter;
    parameter.name = std::string(1, static_cast<char>('a' + k));
    parameter.kind = ParameterKind::axis_angle;  // natural unit 1
    parameter.initial = 0.2 * k - 0.3;
    parameter.lower = parameter.initial - half;
    parameter.upper = parameter.initial + half;
    space.parameters.push_back(parameter);
  }
  return space;
}

const CodesignOptions exact{.design_tolerance = 1e-7,
                            .value_tolerance = 1e-14,
                            .motion_tolerance = 1e-9,
                            .final_tolerance = 1e-10};

CodesignResult run(double half, const CodesignOptions& options = exact) {
  toy::CoupledCost cost(motion_size, design_size);
  return codesign(cost, box(half), VectorXd::Zero(motion_size), options);
}

TEST(Codesign, FindsTheMinimumOverDesignAndMotion) {
  const CodesignResult result = run(10.0);
  EXPECT_EQ(result.status, SolveStatus::converged);
  EXPECT_EQ(result.best.motion_status, SolveStatus::converged);
  EXPECT_LT(result.best.value, result.initial.value - 1e-3);
  // All partial derivatives of F vanish there.
  toy::CoupledCost cost(motion_size, design_size);
  Evaluation at;
  cost.evaluate(result.best.s, result.best.m, Order::design, at);
  EXPECT_LT(at.stationarity.norm(), 1e-8);
  EXPECT_LT(at.partial_s.norm(), 1e-5);
  EXPECT_LT(result.design_iterations, 20);
}

TEST(Codesign, BoundsAreHardAtEveryIterate) {
  const DesignSpace space = box(0.05);
  std::vector<VectorXd> seen;
  CodesignOptions options = exact;
  options.on_iteration = [&](const DesignIteration& i) { return seen.push_back(i.s), true; };
  const CodesignResult result = run(0.05, options);
  EXPECT_EQ(result.status, SolveStatus::converged);
  int touched = 0;
  for (const VectorXd& s : seen) {
    EXPECT_TRUE((s.array() >= space.lower().array()).all());
    EXPECT_TRUE((s.array() <= space.upper().array()).all());
  }
  for (int k = 0; k < design_size; ++k)
    touched += result.best.s[k] == space.lower()[k] || result.best.s[k] == space.upper()[k];
  EXPECT_GT(touched, 0);
  EXPECT_LT(result.best.projected_gradient_norm, 1e-7);
  EXPECT_GT(result.best.design_gradient.lpNorm<Eigen::Infinity>(), 1e-3)
      << "held by the bound, not at rest";
}

TEST(Codesign, IterationsArriveInOrderAndNeverRise) {
  std::vector<DesignIteration> seen;
  CodesignOptions options = exact;
  options.on_iteration = [&](const DesignIteration& i) { return seen.push_back(i), true; };
  const CodesignResult result = run(10.0, options);
  ASSERT_EQ(static_cast<int>(seen.size()), result.design_iterations + 1);
  int newton_iterations = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    EXPECT_EQ(seen[k].index, static_cast<int>(k));
    if (k > 0) {
      EXPECT_LT(seen[k].value, seen[k - 1].value);
    }
    ASSERT_EQ(seen[k].terms.size(), 1u);
    EXPECT_NEAR(seen[k].terms[0].value, seen[k].value, 1e-12);
    newton_iterations += seen[k].newton_iterations;
  }
  EXPECT_EQ(seen[0].value, result.initial.value);
  EXPECT_LE(newton_iterations, result.newton_iterations);  // the polish is not an iteration
}

TEST(Codesign, ReportedGradientMatchesResolvedDifferences) {
  const CodesignResult result = run(10.0, {.final_tolerance = 1e-11, .motion_only = true});
  toy::CoupledCost cost(motion_size, design_size);
  NewtonWorkspace workspace;
  const double h = 1e-5;
  for (int k = 0; k < design_size; ++k) {
    double value[2];
    for (const int side : {0, 1}) {
      VectorXd s = result.initial.s, m = result.initial.m;
      s[k] += side == 0 ? -h : h;
      value[side] = newton(cost, s, m, {.tolerance = 1e-11}, workspace).value;
    }
    EXPECT_NEAR(result.initial.design_gradient[k], (value[1] - value[0]) / (2 * h), 1e-8);
  }
  EXPECT_GT(result.initial.projected_gradient_norm, 1e-2);
}

TEST(Codesign, MotionOnlyLeavesTheDesignAlone) {
  CodesignOptions options = exact;
  options.motion_only = true;
  const CodesignResult result = run(10.0, options);
  EXPECT_EQ(result.status, SolveStatus::converged);
  EXPECT_EQ(result.best.s, box(10.0).initial());
  EXPECT_EQ(result.design_iterations, 0);
}

TEST(Codesign, StopsWhenToldTo) {
  for (const int last : {0, 2}) {
    CodesignOptions options = exact;
    options.on_iteration = [&](const DesignIteration& i) { return i.index < last; };
    const CodesignResult result = run(10.0, options);
    EXPECT_EQ(result.status, SolveStatus::stopped);
    EXPECT_EQ(result.best.index, last);
    EXPECT_TRUE(std::isfinite(result.best.value));
  }
}

TEST(Codesign, SameBitsTwice) {
  const CodesignResult a = run(0.3), b = run(0.3);
  EXPECT_EQ(a.best.s, b.best.s);
  EXPECT_EQ(a.best.m, b.best.m);
  EXPECT_EQ(a.best.value, b.best.value);
  EXPECT_EQ(a.factorisations, b.factorisations);
}

TEST(Codesign, NaNAtAnyCallEndsWithAFiniteIterate) {
  toy::CoupledCost clean(motion_size, design_size);
  const CodesignResult expected = codesign(clean, box(10.0), VectorXd::Zero(motion_size), exact);
  ASSERT_EQ(expected.evaluations, clean.calls);
  for (int k = 1; k <= clean.calls; ++k) {
    toy::CoupledCost cost(motion_size, design_size);
    cost.poisoned_call = k;
    const CodesignResult result = codesign(cost, box(10.0), VectorXd::Zero(motion_size), exact);
    EXPECT_TRUE(result.best.s.allFinite() && result.best.m.allFinite());
    if (k == 1) {
      EXPECT_EQ(result.status, SolveStatus::not_finite);
    }
    if (result.status == SolveStatus::converged) {
      EXPECT_NEAR(result.best.value, expected.best.value, 1e-9) << "call " << k;
      EXPECT_TRUE(result.best.design_gradient.allFinite());
    }
  }
}

/// CoupledCost whose ∂F/∂s and ∂G/∂s have the wrong sign: no step along them can help.
class WrongSign final : public CostFunction {
 public:
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    inner_.evaluate(s, m, order, out);
    if (order < Order::design) return;
    out.partial_s *= -1.0;
    out.hessian_ms *= -1.0;
  }
  const VectorXd& motion_units() const override { return inner_.motion_units(); }

 private:
  toy::CoupledCost inner_{motion_size, design_size};
};

TEST(Codesign, AWrongGradientStallsWithTheInitialDesignKept) {
  WrongSign cost;
  const CodesignResult result = codesign(cost, box(10.0), VectorXd::Zero(motion_size), exact);
  EXPECT_EQ(result.status, SolveStatus::stalled);
  EXPECT_EQ(result.design_iterations, 0);
  EXPECT_EQ(result.best.value, result.initial.value);
  EXPECT_EQ(result.rejected_trials, exact.line_search_steps);
}

}  // namespace
}  // namespace legwright
