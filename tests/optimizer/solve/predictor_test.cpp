// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/predictor.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>
#include <utility>

#include "optimizer/solve/newton.hpp"
#include "tests/optimizer/solve/toy_cost.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

struct Prediction {
  double error = 0.0, distance = 0.0;  // from the predicted and from the old motion to m*(s + Δs)
};

Prediction predict_change(double size, double sign_of_change = 1.0) {
  toy::CoupledCost cost(8, 3);
  NewtonWorkspace workspace;
  const VectorXd s = Eigen::Vector3d(0.4, -0.7, 0.9),
                 change = size * Eigen::Vector3d(1.0, 0.5, -1.0);
  VectorXd m = VectorXd::Zero(8);
  const NewtonOptions tight{.tolerance = 1e-11};
  EXPECT_EQ(newton(cost, s, m, tight, workspace).status, SolveStatus::converged);
  Evaluation at;
  cost.evaluate(s, m, Order::design, at);
  VectorXd ahead, there = m;
  EXPECT_TRUE(
      predict(workspace.factor, m, at.stationarity, at.hessian_ms, sign_of_change * change, ahead));
  EXPECT_EQ(newton(cost, s + change, there, tight, workspace).status, SolveStatus::converged);
  return {(ahead - there).norm(), (m - there).norm()};
}

TEST(Predictor, ErrorIsOfSecondOrder) {
  const Prediction coarse = predict_change(1e-2), fine = predict_change(5e-3);
  EXPECT_LT(coarse.error, 0.1 * coarse.distance);
  EXPECT_NEAR(coarse.error / fine.error, 4.0, 0.3);
  EXPECT_GT(predict_change(1e-2, -1.0).error, coarse.distance)
      << "the wrong sign must be worse than nothing";
}

TEST(Predictor, AlsoTakesTheNewtonStepThatMIsShortOf) {
  toy::CoupledCost cost(8, 3);
  const VectorXd s = Eigen::Vector3d(0.4, -0.7, 0.9), m = VectorXd::Constant(8, 0.1);
  Evaluation at;
  cost.evaluate(s, m, Order::design, at);
  HessianFactor factor;
  ASSERT_TRUE(factor.factor(at.hessian_mm, {}));
  VectorXd ahead, step;
  ASSERT_TRUE(predict(factor, m, at.stationarity, at.hessian_ms, VectorXd::Zero(3), ahead));
  ASSERT_TRUE(factor.solve(-at.stationarity, step));
  EXPECT_LT((ahead - m - step).norm(), 1e-14);
}

TEST(Predictor, StaysWithoutAUsableFactor) {
  toy::CoupledCost cost(8, 3);
  const VectorXd s = VectorXd::Zero(3), m = VectorXd::Constant(8, 0.1);
  Evaluation at;
  cost.evaluate(s, m, Order::design, at);
  HessianFactor factor;
  ASSERT_FALSE(factor.factor(at.hessian_mm, VectorXd::Constant(8, -1e3)));
  VectorXd ahead;
  EXPECT_FALSE(predict(factor, m, at.stationarity, at.hessian_ms, VectorXd::Ones(3), ahead));
  EXPECT_EQ(ahead, m);
}

/// A cost whose correction leads to one and the same motion, whatever that is worth.
class BentTo final : public CostFunction {
 public:
  explicit BentTo(VectorXd end) : end_(std::move(end)) {}
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    cost_.evaluate(s, m, order, out);
  }
  const VectorXd& motion_units() const override { return cost_.motion_units(); }
  void correct_step(const VectorXd&, VectorXd& m) override { m = end_; }

 private:
  toy::CoupledCost cost_{8, 3};
  VectorXd end_;
};

TEST(BentPrediction, IsTakenWhereItHasLessF) {
  const VectorXd s = VectorXd::Constant(3, 0.5), near = VectorXd::Zero(8),
                 far = VectorXd::Constant(8, 30.0);
  Evaluation at;
  const auto value = [&](const VectorXd& m) {
    toy::CoupledCost(8, 3).evaluate(s, m, Order::value, at);
    return at.value;
  };
  ASSERT_LT(value(near), value(far));
  for (const auto& [from, to, end] :
       {std::tuple(far, near, near), std::tuple(near, far, near), std::tuple(near, near, near)}) {
    BentTo cost(to);
    VectorXd ahead = from;
    const PredictedValue found = bend_prediction(cost, s, near, s, ahead, at);
    EXPECT_EQ(ahead, end);
    EXPECT_EQ(found.value, value(end));
    EXPECT_EQ(found.evaluations, from == to ? 1 : 2);
  }
  BentTo nowhere(VectorXd::Constant(8, std::numeric_limits<double>::quiet_NaN()));
  VectorXd ahead = far;
  EXPECT_EQ(bend_prediction(nowhere, s, near, s, ahead, at).value, value(far));
  EXPECT_EQ(ahead, far);
}

/// One change of the puppy put back, as co-designs do: feet and COM of the straight prediction miss
/// the pose. From either Newton's method comes to the same motion.
TEST(BentPrediction, IsNearerToTheMotionOfARobot) {
  const test::Puppy puppy = test::make_puppy(true);
  const Objective walk(puppy.morphology, puppy.space, test::make_sideways_task(false, 8));
  ObjectiveCost cost(walk);
  const VectorXd old = puppy.space.initial();
  VectorXd s = old;
  s[6] += 0.1;
  NewtonWorkspace workspace;
  VectorXd m = test::standing_motion(walk, s);
  const NewtonOptions tight{.tolerance = 1e-8, .max_iterations = 400};
  ASSERT_EQ(newton(cost, s, m, tight, workspace).status, SolveStatus::converged);
  Evaluation at;
  cost.evaluate(s, m, Order::design, at);
  VectorXd straight;
  ASSERT_TRUE(predict(workspace.factor, m, at.stationarity, at.hessian_ms, old - s, straight));
  VectorXd bent = straight;
  const PredictedValue found = bend_prediction(cost, s, m, old, bent, at);
  cost.evaluate(old, straight, Order::value, at);
  const double before = at.value;
  const SolveReport long_way = newton(cost, old, straight, tight, workspace);
  const SolveReport short_way = newton(cost, old, bent, tight, workspace);
  EXPECT_EQ(short_way.status, SolveStatus::converged);
  EXPECT_NEAR(short_way.value, long_way.value, 1e-9 * long_way.value);
  EXPECT_LT(found.value - short_way.value, 0.5 * (before - short_way.value));
}

}  // namespace
}  // namespace legwright
