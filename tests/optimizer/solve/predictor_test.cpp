// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/predictor.hpp"

#include <gtest/gtest.h>

#include "optimizer/solve/newton.hpp"
#include "tests/optimizer/solve/toy_cost.hpp"

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

}  // namespace
}  // namespace legwright
