// SPDX-License-Identifier: Apache-2.0
#include "tools/session/weight_lattice.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/optimizer/solve/toy_cost.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// F = ½ (m − s₀)² + ½ |s − c|²: with weights that sum to 1 the best s is Σ wᵢ cᵢ.
class PulledTo final : public CostFunction {
 public:
  PulledTo(double x, double y) : c_(2) { c_ << x, y; }
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    const double off = m[0] - s[0];
    const VectorXd away = s - c_;
    out.value = 0.5 * off * off + 0.5 * away.squaredNorm();
    if (order >= Order::gradient) out.stationarity = VectorXd::Constant(1, off);
    if (order >= Order::hessian) out.hessian_mm = toy::lower_triangle(MatrixXd::Identity(1, 1));
    if (order < Order::design) return;
    out.partial_s = away;
    out.partial_s[0] -= off;
    out.hessian_ms = MatrixXd::Zero(1, 2);
    out.hessian_ms(0, 0) = -1.0;
    out.hessian_ss = MatrixXd::Identity(2, 2);
    out.hessian_ss(0, 0) += 1.0;
  }
  const VectorXd& motion_units() const override { return units_; }

 private:
  VectorXd c_;
  VectorXd units_ = VectorXd::Ones(1);
};

DesignSpace plane() {
  DesignSpace space;
  for (const char* name : {"x", "y"}) {
    DesignParameter one;
    one.name = name;
    one.kind = ParameterKind::axis_angle;
    one.lower = -3.0;
    one.upper = 3.0;
    space.parameters.push_back(one);
  }
  return space;
}

class LatticeOfThree : public testing::Test {
 protected:
  static JointTask task(CostFunction& cost) {
    JointTask out;
    out.cost = &cost;
    out.weight = 1.0 / 3.0;
    out.guess = [](const VectorXd& s) { return VectorXd::Constant(1, s[0] + 0.3); };
    return out;
  }
  MultistartResult found() {
    MultistartResult out;
    for (int k = 0; k < 3; ++k) {
      WeightedCost cost = weighted(tasks_[static_cast<std::size_t>(k)], 1.0, VectorXd::Zero(1));
      out.alone.push_back({{"initial", {k}}, codesign({cost}, space_, VectorXd::Zero(2), {})});
    }
    return out;
  }

  std::array<PulledTo, 3> costs_{PulledTo{0.0, 0.0}, PulledTo{1.0, 0.0}, PulledTo{0.0, 1.0}};
  DesignSpace space_ = plane();
  std::vector<JointTask> tasks_{task(costs_[0]), task(costs_[1]), task(costs_[2])};
};

TEST_F(LatticeOfThree, EachPointIsTheOptimumOfItsWeights) {
  const auto points = lattice_front(tasks_, space_, found(), 4, {});
  ASSERT_EQ(points.size(), 15u);
  EXPECT_EQ(points.front().weights, (std::vector{1.0, 0.0, 0.0}));
  EXPECT_EQ(points.back().weights, (std::vector{0.0, 0.0, 1.0}));
  for (const LatticePoint& point : points) {
    ASSERT_EQ(point.best.tasks.size(), 3u);
    EXPECT_NEAR(point.best.s[0], point.weights[1], 1e-3);
    EXPECT_NEAR(point.best.s[1], point.weights[2], 1e-3);
    EXPECT_NEAR(point.best.tasks[2].m[0], point.best.s[0], 1e-3) << "solved with weight 0, too";
  }
}

TEST_F(LatticeOfThree, AKnownDesignThatIsBetterIsTaken) {
  MultistartResult all = found();
  CodesignOptions stopped;
  stopped.go_on = [] { return false; };
  EXPECT_LE(lattice_front(tasks_, space_, all, 2, stopped).size(), 6u) << "as far as it came";
  // Corners alone are not the best of any weights between them.
  const auto points = lattice_front(tasks_, space_, all, 2, {});
  for (const LatticePoint& point : points)
    for (const StartedRun& run : all.alone) {
      double there = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        Evaluation at;
        const VectorXd m = VectorXd::Constant(1, run.result.best.s[0]);
        costs_[k].evaluate(run.result.best.s, m, Order::value, at);
        there += point.weights[k] * at.value;
      }
      EXPECT_LE(point.best.value, there + 1e-9);
    }
}

}  // namespace
}  // namespace legwright
