// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/multistart.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimizer/solve/toy_cost.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// F = ½ (m − s)² + (s² − 1)² + tilt s: two valleys over s, the lower one on the side −sign(tilt).
class TwoValleys final : public CostFunction {
 public:
  explicit TwoValleys(double tilt, double middle = 0.0) : tilt_(tilt), middle_(middle) {}
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    const double x = s[0] - middle_, off = m[0] - s[0], well = x * x - 1.0;
    out.value = 0.5 * off * off + well * well + tilt_ * x;
    if (order >= Order::gradient) out.stationarity = VectorXd::Constant(1, off);
    if (order >= Order::hessian)
      out.hessian_mm = toy::lower_triangle(Eigen::MatrixXd::Identity(1, 1));
    if (order >= Order::design) {
      out.partial_s = VectorXd::Constant(1, -off + 4.0 * well * x + tilt_);
      out.hessian_ms = Eigen::MatrixXd::Constant(1, 1, -1.0);
      out.hessian_ss = Eigen::MatrixXd::Constant(1, 1, 1.0 + 12.0 * x * x - 4.0);
    }
  }
  const VectorXd& motion_units() const override { return units_; }

 private:
  double tilt_, middle_;
  VectorXd units_ = VectorXd::Ones(1);
};

DesignSpace line(double initial) {
  DesignParameter x;
  x.name = "x";
  x.kind = ParameterKind::axis_angle;
  x.initial = initial;
  x.lower = -3.0;
  x.upper = 3.0;
  return {{x}};
}

JointTask task(const std::string& name, CostFunction& cost, double weight) {
  JointTask result;
  result.name = name;
  result.cost = &cost;
  result.weight = weight;
  result.guess = [](const VectorXd& s) { return VectorXd::Constant(1, s[0] + 0.3); };
  return result;
}

MultistartOptions tight_starts() {
  MultistartOptions options;
  options.codesign.design_tolerance = 1e-8;
  options.codesign.value_tolerance = 1e-14;
  return options;
}

TEST(Multistart, TheOptimumOfOneTaskAloneIsAStartForAll) {
  // From the initial design both tasks together slide into the higher valley at +1; the second task
  // alone, so tilted that it has no valley there, finds the lower one at −1.
  TwoValleys first(0.0), second(2.0);
  const DesignSpace space = line(0.6);
  MultistartOptions options = tight_starts();
  const std::vector<JointTask> tasks{task("first", first, 0.5), task("second", second, 0.5)};
  const MultistartResult all = codesign_from_starts(tasks, space, options);
  ASSERT_EQ(all.alone.size(), 2u);
  ASSERT_EQ(all.joint.size(), 3u);
  EXPECT_EQ(all.joint[2].label.start, "second");
  for (const StartedRun& run : all.joint) EXPECT_GE(run.result.best.value, all.winner().best.value);
  options.from_single_tasks = false;
  const MultistartResult one = codesign_from_starts(tasks, space, options);
  ASSERT_EQ(one.joint.size(), 1u);
  EXPECT_LT(all.winner().best.value, one.winner().best.value - 1e-2)
      << "several starts gained nothing";
}

TEST(Multistart, PerturbationsAreSeededAndStayInTheBox) {
  TwoValleys cost(0.3);
  DesignSpace space = line(0.1);
  space.parameters[0].lower = 0.0;
  MultistartOptions options = tight_starts();
  options.perturbations = 4;
  options.spread = 2.0;
  const std::vector<JointTask> tasks{task("only", cost, 1.0)};
  const MultistartResult a = codesign_from_starts(tasks, space, options);
  const MultistartResult b = codesign_from_starts(tasks, space, options);
  options.seed = 2;
  const MultistartResult c = codesign_from_starts(tasks, space, options);
  ASSERT_EQ(a.joint.size(), 5u);
  EXPECT_TRUE(a.alone.empty());
  bool differs = false;
  for (std::size_t k = 0; k < a.joint.size(); ++k) {
    const double start = a.joint[k].result.initial.s[0];
    EXPECT_GE(start, 0.0);
    EXPECT_EQ(start, b.joint[k].result.initial.s[0]);
    differs = differs || start != c.joint[k].result.initial.s[0];
  }
  EXPECT_TRUE(differs);
}

TEST(Multistart, StopsEverythingWhenToldTo) {
  TwoValleys first(0.2), second(-0.2);
  MultistartOptions options = tight_starts();
  int calls = 0;
  options.on_iteration = [&](const RunLabel&, const DesignIteration&) { return ++calls < 3; };
  const MultistartResult result =
      codesign_from_starts({task("a", first, 0.5), task("b", second, 0.5)}, line(0.4), options);
  EXPECT_TRUE(result.stopped);
  EXPECT_EQ(calls, 3);
  EXPECT_TRUE(result.winner().best.s.allFinite());
}

TEST(Front, TradesOneTaskForTheOther) {
  TwoValleys first(0.0, 0.0), second(0.0, 0.4);  // valleys at 1 and 1.4
  const std::vector<JointTask> tasks{task("first", first, 0.5), task("second", second, 0.5)};
  const MultistartOptions options = tight_starts();
  const DesignSpace space = line(0.8);
  const MultistartResult starts = codesign_from_starts(tasks, space, options);
  const std::vector<FrontPoint> front = trade_off_front(tasks, space, starts, 5, options.codesign);
  ASSERT_EQ(front.size(), 7u);
  EXPECT_EQ(front.front().weight, 0.0);
  EXPECT_EQ(front.back().weight, 1.0);
  for (std::size_t k = 1; k < front.size(); ++k) {
    EXPECT_LE(front[k].best.tasks[0].value, front[k - 1].best.tasks[0].value + 1e-9);
    EXPECT_GE(front[k].best.tasks[1].value, front[k - 1].best.tasks[1].value - 1e-9);
  }
  EXPECT_NEAR(front.back().best.s[0], 1.0, 1e-6);
  EXPECT_NEAR(front.front().best.s[0], 1.4, 1e-6);
}

// From the initial design each task slides into the higher valley at +1, and so would every point
// between them; a perturbed start of both together finds the lower one at −1.
TEST(Front, HasNoPointAboveAJointRun) {
  TwoValleys first(0.3), second(0.5, 0.1);
  const std::vector<JointTask> tasks{task("first", first, 0.35), task("second", second, 0.65)};
  MultistartOptions options = tight_starts();
  options.perturbations = 6;
  options.spread = 2.0;
  const DesignSpace space = line(0.6);
  const MultistartResult starts = codesign_from_starts(tasks, space, options);
  const DesignIteration& winner = starts.winner().best;
  ASSERT_LT(winner.s[0], 0.0);
  ASSERT_GT(starts.alone[0].result.best.s[0], 0.0);
  const std::vector<FrontPoint> front = trade_off_front(tasks, space, starts, 3, options.codesign);
  ASSERT_EQ(front.size(), 6u) << "the joint run's own weight is among them";
  bool joint_weight = false;
  for (const FrontPoint& point : front) {
    for (const auto& other : {winner, front[0].best, front[2].best, front[4].best}) {
      const double there =
          point.weight * other.tasks[0].value + (1.0 - point.weight) * other.tasks[1].value;
      EXPECT_LE(point.best.value, there + 1e-9) << "weight " << point.weight;
    }
    if (std::abs(point.weight - 0.35) < 1e-12) {
      joint_weight = true;
      EXPECT_NEAR(point.best.value, winner.value, 1e-9);
    }
  }
  EXPECT_TRUE(joint_weight);
}

TEST(Front, NeedsTwoTasks) {
  TwoValleys cost(0.0);
  EXPECT_THROW(
      (void)trade_off_front({task("only", cost, 1.0)}, line(0.8), {}, 3, CodesignOptions{}),
      std::invalid_argument);
}

}  // namespace
}  // namespace legwright
