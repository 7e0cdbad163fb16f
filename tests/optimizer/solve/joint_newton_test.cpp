// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/joint_newton.hpp"

#include <gtest/gtest.h>

#include "optimizer/solve/codesign.hpp"
#include "optimizer/solve/lbfgs.hpp"
#include "tests/optimizer/solve/toy_cost.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;
using toy::kDesignSize;
using toy::kMotionSize;

DesignBox toy_box(double half) {
  const DesignSpace space = toy::box(half);
  return {space.lower(), space.upper(), space.scale()};
}

/// Two tasks for one body, or the first alone.
struct Toys {
  toy::CoupledCost first{kMotionSize, kDesignSize, 7}, second{kMotionSize, kDesignSize, 11};
  std::vector<WeightedCost> tasks() {
    std::vector<WeightedCost> out(2);
    out[0].cost = &first;
    out[0].weight = 0.3;
    out[1].cost = &second;
    out[1].weight = 0.7;
    for (WeightedCost& task : out) task.initial_motion = rest();
    return out;
  }
  static VectorXd rest() { return VectorXd::Zero(kMotionSize); }
  JointNewtonResult run(double half, const JointNewtonOptions& options = {}) {
    return joint_newton(tasks(), toy_box(half), toy::box(half).initial(), {{rest(), rest()}},
                        options);
  }
};

JointNewtonOptions strict() {
  JointNewtonOptions options;
  options.motion_tolerance = options.design_tolerance = 1e-9;
  options.stagnation_decrease = 1e-15;
  return options;
}

TEST(JointNewton, FindsWhatAlgorithm1Finds) {
  Toys toys;
  CodesignOptions rules;
  rules.method = DesignMethod::newton;
  rules.design_tolerance = 1e-9;
  rules.value_tolerance = 1e-15;
  rules.motion_tolerance = rules.final_tolerance = 1e-11;
  const CodesignResult bilevel =
      codesign(toys.tasks(), toy::box(10.0), toy::box(10.0).initial(), rules);
  const JointNewtonResult joint = toys.run(10.0, strict());
  ASSERT_EQ(bilevel.status, SolveStatus::converged);
  ASSERT_EQ(joint.status, SolveStatus::converged);
  EXPECT_LT((joint.best().s - bilevel.best.s).norm(), 1e-7);
  for (int k = 0; k < 2; ++k)
    EXPECT_LT((joint.best().motions[k] - bilevel.best.tasks[k].m).norm(), 1e-7);
  EXPECT_LT(joint.iterations, bilevel.newton_iterations);
}

TEST(JointNewton, KeepsBoundsAndFallsAllTheWay) {
  Toys toys;
  JointNewtonOptions options = strict();
  options.told_change = 0.0;  // every point
  const JointNewtonResult found = toys.run(0.05, options);
  ASSERT_EQ(found.status, SolveStatus::converged);
  ASSERT_EQ(found.path.size(), static_cast<std::size_t>(found.iterations) + 1);
  const DesignBox box = toy_box(0.05);
  bool at_bound = false;
  for (std::size_t k = 0; k < found.path.size(); ++k) {
    const JointPoint& point = found.path[k];
    EXPECT_TRUE((point.s.array() >= box.lower.array()).all());
    EXPECT_TRUE((point.s.array() <= box.upper.array()).all());
    if (k > 0) {
      EXPECT_LE(point.value, found.path[k - 1].value * (1.0 + 1e-12));
    }
  }
  for (int k = 0; k < kDesignSize; ++k)
    at_bound = at_bound || found.best().s[k] == box.lower[k] || found.best().s[k] == box.upper[k];
  EXPECT_TRUE(at_bound) << "no bound is active: this test shows nothing";
}

TEST(JointNewton, SameBitsAtAnyThreadCount) {
  Toys a, b;
  JointNewtonOptions many = strict();
  many.threads = 4;
  const JointNewtonResult one = a.run(10.0, strict()), four = b.run(10.0, many);
  EXPECT_EQ(one.best().s, four.best().s);
  EXPECT_EQ(one.best().motions[1], four.best().motions[1]);
  EXPECT_EQ(one.factorisations, four.factorisations);
}

TEST(JointNewton, EndsWhereItIsToldTo) {
  Toys toys;
  JointNewtonOptions options = strict();
  options.max_iterations = 2;
  const JointNewtonResult two = toys.run(10.0, options);
  EXPECT_EQ(two.status, SolveStatus::iteration_limit);
  EXPECT_EQ(two.iterations, 2);
  options.max_iterations = 0;
  const JointNewtonResult none = toys.run(10.0, options);
  EXPECT_EQ(none.status, SolveStatus::iteration_limit);
  EXPECT_EQ(none.best().s, toy::box(10.0).initial()) << "the start is the best that is known";
  options = strict();
  int asked = 0;
  options.go_on = [&] { return ++asked < 3; };
  const JointNewtonResult stopped = toys.run(10.0, options);
  EXPECT_EQ(stopped.status, SolveStatus::stopped);
  EXPECT_EQ(stopped.best().s, two.best().s) << "the best so far is handed back";
}

TEST(JointNewton, NaNNeverConverges) {
  for (int call = 1; call < 40; ++call) {
    Toys toys;
    toys.second.poisoned_call = call;
    const JointNewtonResult found = toys.run(10.0, strict());
    Toys fresh;
    for (const JointPoint& point : found.path) {
      const std::vector<WeightedCost> tasks = fresh.tasks();
      double value = 0.0;
      for (std::size_t k = 0; k < tasks.size(); ++k) {
        Evaluation at;
        tasks[k].cost->evaluate(point.s, point.motions[k], Order::value, at);
        value += tasks[k].weight * at.value;
      }
      EXPECT_NEAR(point.value, value, 1e-12) << "call " << call << ": F of another point";
    }
    if (call == 1) {
      EXPECT_EQ(found.status, SolveStatus::not_finite);
      EXPECT_TRUE(found.path.empty());
    }
  }
}

/// The lowest of several starts goes on, and all count.
TEST(JointNewton, PursuesTheBetterStart) {
  Toys toys;
  JointNewtonOptions options = strict();
  options.scout_iterations = 3;
  const VectorXd far = VectorXd::Constant(kMotionSize, 4.0);
  const JointNewtonResult near = toys.run(10.0, strict());
  const JointNewtonResult both = joint_newton(toys.tasks(), toy_box(10.0), toy::box(10.0).initial(),
                                              {{far, far}, {Toys::rest(), Toys::rest()}}, options);
  EXPECT_EQ(both.best().s, near.best().s);
  EXPECT_EQ(both.iterations, near.iterations + 3);
}

/// The puppy that is asked to walk sideways.
class PuppyJointNewton : public testing::Test {
 protected:
  JointNewtonResult run(CostFunction& cost, const std::vector<std::vector<VectorXd>>& starts,
                        const JointNewtonOptions& options) const {
    const DesignSpace& space = objective.space();
    WeightedCost task;
    task.cost = &cost;
    return joint_newton({task}, {space.lower(), space.upper(), space.scale()}, space.initial(),
                        starts, options);
  }

  const test::Puppy puppy = test::make_puppy(true);
  const Objective objective{puppy.morphology, puppy.space, test::make_sideways_task(true, 12)};
  const VectorXd guess = initial_guess(objective, objective.space().initial());
};

/// Searches of one cost take turns; each goes on as if it were alone.
TEST_F(PuppyJointNewton, StartsDoNotDisturbEachOther) {
  ObjectiveCost cost(objective);
  JointNewtonOptions options;
  options.max_iterations = 15;
  options.scout_iterations = 8;
  const VectorXd worse = guess + 0.3 * cost.motion_units();
  const JointNewtonResult alone = run(cost, {{guess}}, options);
  const JointNewtonResult both = run(cost, {{guess}, {worse}}, options);
  ASSERT_EQ(both.iterations, alone.iterations + 8);
  EXPECT_EQ(both.best().s, alone.best().s);
  EXPECT_EQ(both.best().value, alone.best().value);
}

/// Eq (12) bends steps: without that the puppy takes more of them.
class StraightCost final : public CostFunction {
 public:
  explicit StraightCost(const Objective& objective) : cost_(objective) {}
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    cost_.evaluate(s, m, order, out);
  }
  const VectorXd& motion_units() const override { return cost_.motion_units(); }

 private:
  ObjectiveCost cost_;
};

TEST_F(PuppyJointNewton, CorrectedStepsGoFartherThanStraightOnes) {
  JointNewtonOptions options;
  options.max_iterations = 40;
  ObjectiveCost bent(objective);
  StraightCost straight(objective);
  const double with = run(bent, {{guess}}, options).best().value;
  const double without = run(straight, {{guess}}, options).best().value;
  EXPECT_LT(with, 0.8 * without);
}

}  // namespace
}  // namespace legwright
