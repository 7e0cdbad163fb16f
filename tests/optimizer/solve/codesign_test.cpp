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
using toy::kDesignSize;
using toy::kMotionSize;

/// Algorithm 1 by itself.
CodesignOptions tight() {
  CodesignOptions options;
  options.method = DesignMethod::newton;
  options.design_tolerance = 1e-7;
  options.value_tolerance = 1e-14;
  options.motion_tolerance = 1e-9;
  options.final_tolerance = 1e-10;
  return options;
}
const CodesignOptions exact = tight();

CodesignResult run_one(CostFunction& cost, double half, const CodesignOptions& options = exact) {
  WeightedCost task;
  task.cost = &cost;
  task.initial_motion = VectorXd::Zero(kMotionSize);
  return codesign({task}, toy::box(half), toy::box(half).initial(), options);
}

CodesignResult run(double half, const CodesignOptions& options = exact) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  return run_one(cost, half, options);
}

TEST(Codesign, FindsTheMinimumOverDesignAndMotion) {
  const CodesignResult result = run(10.0);
  EXPECT_EQ(result.status, SolveStatus::converged);
  EXPECT_EQ(result.best.motion_status(), SolveStatus::converged);
  EXPECT_LT(result.best.value, result.initial.value - 1e-3);
  // All partial derivatives of F vanish there.
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  Evaluation at;
  cost.evaluate(result.best.s, result.best.tasks[0].m, Order::design, at);
  EXPECT_LT(at.stationarity.norm(), 1e-8);
  EXPECT_LT(at.partial_s.norm(), 1e-5);
  EXPECT_LT(result.design_iterations, 20);
}

TEST(Codesign, BoundsAreHardAtEveryIterate) {
  const DesignSpace space = toy::box(0.05);
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
  for (int k = 0; k < kDesignSize; ++k)
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
    ASSERT_EQ(seen[k].tasks[0].terms.size(), 1u);
    EXPECT_NEAR(seen[k].tasks[0].terms[0].value, seen[k].value, 1e-12);
    newton_iterations += seen[k].newton_iterations;
  }
  EXPECT_EQ(seen[0].value, result.initial.value);
  EXPECT_LE(newton_iterations, result.newton_iterations);  // the polish is not an iteration
}

TEST(Codesign, ReportedGradientMatchesResolvedDifferences) {
  CodesignOptions options = exact;
  options.final_tolerance = 1e-11;
  options.motion_only = true;
  const CodesignResult result = run(10.0, options);
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  NewtonWorkspace workspace;
  const double h = 1e-5;
  for (int k = 0; k < kDesignSize; ++k) {
    double value[2];
    for (const int side : {0, 1}) {
      VectorXd s = result.initial.s, m = result.initial.tasks[0].m;
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
  EXPECT_EQ(result.best.s, toy::box(10.0).initial());
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
  EXPECT_EQ(a.best.tasks[0].m, b.best.tasks[0].m);
  EXPECT_EQ(a.best.value, b.best.value);
  EXPECT_EQ(a.factorisations, b.factorisations);
}

TEST(Codesign, NaNAtAnyCallEndsWithAFiniteIterate) {
  toy::CoupledCost clean(kMotionSize, kDesignSize);
  const CodesignResult expected = run_one(clean, 10.0);
  ASSERT_EQ(expected.evaluations, clean.calls);
  for (int k = 1; k <= clean.calls; ++k) {
    toy::CoupledCost cost(kMotionSize, kDesignSize);
    cost.poisoned_call = k;
    const CodesignResult result = run_one(cost, 10.0);
    EXPECT_TRUE(result.best.s.allFinite() && result.best.tasks[0].m.allFinite());
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
  toy::CoupledCost inner_{kMotionSize, kDesignSize};
};

TEST(Codesign, AWrongGradientStallsWithTheInitialDesignKept) {
  WrongSign cost;
  const CodesignResult result = run_one(cost, 10.0);
  EXPECT_EQ(result.status, SolveStatus::stalled);
  EXPECT_EQ(result.design_iterations, 0);
  EXPECT_EQ(result.best.value, result.initial.value);
  EXPECT_GE(result.rejected_trials, exact.line_search_steps);
}

TEST(Codesign, BothMethodsFindTheSameMinimumNewtonInFewerSteps) {
  CodesignOptions paper = exact;
  paper.method = DesignMethod::lbfgs;
  const CodesignResult newton = run(10.0), lbfgs = run(10.0, paper);
  EXPECT_EQ(newton.status, SolveStatus::converged);
  EXPECT_EQ(lbfgs.status, SolveStatus::converged);
  EXPECT_LT((newton.best.s - lbfgs.best.s).norm(), 1e-5);
  EXPECT_LT(newton.design_iterations, lbfgs.design_iterations);
}

TEST(Codesign, StepsBodyAndMotionTogetherByDefault) {
  CodesignOptions options = exact;
  options.method = CodesignOptions{}.method;
  ASSERT_EQ(options.method, DesignMethod::joint);
  std::vector<DesignIteration> seen;
  options.on_iteration = [&](const DesignIteration& i) { return seen.push_back(i), true; };
  const CodesignResult joint = run(10.0, options), bilevel = run(10.0);
  ASSERT_EQ(joint.status, SolveStatus::converged);
  EXPECT_LT((joint.best.s - bilevel.best.s).norm(), 1e-6);
  EXPECT_EQ(joint.initial.value, bilevel.initial.value) << "iteration 0 is the given body's own";
  ASSERT_EQ(static_cast<int>(seen.size()), joint.design_iterations + 1);
  for (std::size_t k = 0; k < seen.size(); ++k) {
    EXPECT_EQ(seen[k].index, static_cast<int>(k));
    if (k > 0) {
      EXPECT_LT(seen[k].value, seen[k - 1].value);
    }
  }
  EXPECT_GT(joint.best.reduced_hessian.size(), 0);
  // As many of its points as there may be iterations, the best one among them.
  options.max_iterations = 1;
  options.on_iteration = {};
  const CodesignResult one = run(10.0, options);
  EXPECT_EQ(one.design_iterations, 1);
  EXPECT_NEAR(one.best.value, joint.best.value, 1e-9);
}

/// The way begins at the first motion, which may be far from the best one: points above iteration 0
/// are no iterations.
TEST(Codesign, NeverRisesAboveIterationZeroHoweverBadTheFirstMotion) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  WeightedCost task;
  task.cost = &cost;
  task.initial_motion = VectorXd::Constant(kMotionSize, 30.0);
  for (const int limit : {1, 2, 3, 60}) {
    CodesignOptions options = exact;
    options.method = DesignMethod::joint;
    options.max_iterations = limit;
    std::vector<double> values;
    options.on_iteration = [&](const DesignIteration& i) {
      return values.push_back(i.value), true;
    };
    const CodesignResult result =
        codesign({task}, toy::box(10.0), toy::box(10.0).initial(), options);
    EXPECT_LE(result.design_iterations, limit);
    EXPECT_LT(result.best.value, result.initial.value);
    for (std::size_t k = 1; k < values.size(); ++k) EXPECT_LT(values[k], values[k - 1]) << limit;
  }
}

TEST(Codesign, NaNOnTheWayOfBodyAndMotionNeverConverges) {
  for (int call = 2; call < 80; call += 3) {
    toy::CoupledCost cost(kMotionSize, kDesignSize);
    cost.poisoned_call = call;
    CodesignOptions options = exact;
    options.method = DesignMethod::joint;
    const CodesignResult result = run_one(cost, 10.0, options);
    EXPECT_TRUE(result.best.s.allFinite()) << "call " << call;
    if (result.status != SolveStatus::converged) continue;
    EXPECT_LT(result.best.projected_gradient_norm, exact.design_tolerance) << "call " << call;
    EXPECT_TRUE(std::isfinite(result.best.value)) << "call " << call;
  }
}

TEST(Codesign, AStopBetweenIterationsKeepsTheBestSoFar) {
  CodesignOptions options = exact;
  options.method = DesignMethod::joint;
  int asked = 0;
  options.go_on = [&] { return ++asked < 4; };
  const CodesignResult result = run(10.0, options);
  EXPECT_EQ(result.status, SolveStatus::stopped);
  EXPECT_EQ(result.design_iterations, 1);
  EXPECT_LT(result.best.value, result.initial.value);
}

/// Two different tasks for one body.
struct Pair {
  toy::CoupledCost first{kMotionSize, kDesignSize, 7}, second{kMotionSize, kDesignSize, 11};
  std::vector<WeightedCost> tasks(double weight) {
    std::vector<WeightedCost> result(2);
    result[0].cost = &first;
    result[0].weight = weight;
    result[1].cost = &second;
    result[1].weight = 1.0 - weight;
    for (WeightedCost& task : result) task.initial_motion = VectorXd::Zero(kMotionSize);
    return result;
  }
  CodesignResult run(double weight, const CodesignOptions& options = exact) {
    return codesign(tasks(weight), toy::box(10.0), toy::box(10.0).initial(), options);
  }
};

TEST(JointCodesign, MinimisesTheWeightedSum) {
  Pair pair;
  const CodesignResult result = pair.run(0.3);
  ASSERT_EQ(result.status, SolveStatus::converged);
  ASSERT_EQ(result.best.tasks.size(), 2u);
  EXPECT_NEAR(result.best.value,
              0.3 * result.best.tasks[0].value + 0.7 * result.best.tasks[1].value, 1e-12);
  // Each motion is at rest, and the pulls of the two tasks on the body cancel.
  const VectorXd pull = 0.3 * result.best.tasks[0].design_gradient;
  EXPECT_GT(pull.norm(), 1e-2) << "the tasks do not disagree: this test shows nothing";
  EXPECT_LT((pull + 0.7 * result.best.tasks[1].design_gradient).norm(), 1e-6);
  for (const TaskIterate& task : result.best.tasks) EXPECT_LT(task.stationarity, 1e-8);
}

TEST(JointCodesign, ASingleTaskIsBetterAtItsOwn) {
  Pair pair;
  WeightedCost alone = pair.tasks(0.5)[0];
  const CodesignResult own = codesign({alone}, toy::box(10.0), toy::box(10.0).initial(), exact);
  const CodesignResult joint = pair.run(0.5);
  EXPECT_LT(own.best.tasks[0].value, joint.best.tasks[0].value - 1e-4);
}

TEST(JointCodesign, SameBitsAtAnyThreadCount) {
  CodesignOptions many = exact;
  many.threads = 4;
  Pair a, b;
  const CodesignResult one = a.run(0.4), four = b.run(0.4, many);
  EXPECT_EQ(one.best.s, four.best.s);
  EXPECT_EQ(one.best.value, four.best.value);
  EXPECT_EQ(one.best.tasks[1].m, four.best.tasks[1].m);
  EXPECT_EQ(one.factorisations, four.factorisations);
}

TEST(JointCodesign, NaNInOneTaskNeverConverges) {
  for (int k = 2; k < 60; k += 3) {
    Pair pair;
    pair.second.poisoned_call = k;
    const CodesignResult result = pair.run(0.5);
    EXPECT_TRUE(result.best.s.allFinite()) << "call " << k;
    for (const TaskIterate& task : result.best.tasks) EXPECT_TRUE(task.m.allFinite());
    if (result.status == SolveStatus::converged) {
      EXPECT_LT(result.best.projected_gradient_norm, exact.design_tolerance);
    }
  }
}

/// J(s, m) = ½ ‖m − target‖² + ½ weight ‖s‖²: pulls the motion where F does not want it.
class Distance final : public CostFunction {
 public:
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    const VectorXd off = m - VectorXd::Constant(m.size(), 0.5);
    out.value = 0.5 * off.squaredNorm() + 0.05 * s.squaredNorm();
    if (order >= Order::gradient) out.stationarity = off;
    if (order == Order::gradients || order == Order::design) out.partial_s = 0.1 * s;
  }
  const VectorXd& motion_units() const override { return units_; }

 private:
  VectorXd units_ = VectorXd::Ones(kMotionSize);
};

TEST(OuterObjective, IsMinimisedOverDesignsWhoseMotionMinimisesF) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  Distance outer;
  WeightedCost task;
  task.cost = &cost;
  task.outer = &outer;
  task.initial_motion = VectorXd::Zero(kMotionSize);
  const CodesignResult result = codesign({task}, toy::box(10.0), toy::box(10.0).initial(), exact);
  const CodesignResult without = run(10.0);
  ASSERT_EQ(result.status, SolveStatus::converged);
  EXPECT_LT(result.best.tasks[0].stationarity, 1e-8);
  EXPECT_GT((result.best.s - without.best.s).norm(), 1e-2);
  EXPECT_NEAR(result.best.value, result.best.tasks[0].value + result.best.tasks[0].outer_value,
              1e-12);
  // From its optimum the search for F + J does not go back to that of F.
  CodesignOptions near = exact;
  near.near_optimum = true;
  task.initial_motion = result.best.tasks[0].m;
  const CodesignResult again = codesign({task}, toy::box(10.0), result.best.s, near);
  EXPECT_EQ(again.status, SolveStatus::converged);
  EXPECT_LE(again.design_iterations, 1);
  // F + J at re-solved motions is stationary in s: there the adjoint does real work.
  NewtonWorkspace workspace;
  const double h = 1e-5;
  for (int k = 0; k < kDesignSize; ++k) {
    double value[2];
    for (const int side : {0, 1}) {
      VectorXd s = result.best.s, m = result.best.tasks[0].m;
      s[k] += side == 0 ? -h : h;
      NewtonOptions options;
      options.tolerance = 1e-11;
      value[side] = newton(cost, s, m, options, workspace).value;
      Evaluation at;
      outer.evaluate(s, m, Order::value, at);
      value[side] += at.value;
    }
    EXPECT_NEAR((value[1] - value[0]) / (2 * h), 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace legwright
