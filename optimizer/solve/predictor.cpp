// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/predictor.hpp"

#include <cmath>
#include <utility>

namespace legwright {

bool predict(HessianFactor& factor, const Eigen::VectorXd& m, const Eigen::VectorXd& stationarity,
             const Eigen::MatrixXd& hessian_ms, const Eigen::VectorXd& design_change,
             Eigen::VectorXd& ahead) {
  Eigen::VectorXd step;
  const Eigen::VectorXd right = -(hessian_ms * design_change + stationarity);
  const bool solved = factor.positive() && factor.solve(right, step);
  ahead = solved ? Eigen::VectorXd(m + step) : m;
  return solved;
}

PredictedValue bend_prediction(CostFunction& cost, const Eigen::VectorXd& s0,
                               const Eigen::VectorXd& m0, const Eigen::VectorXd& s,
                               Eigen::VectorXd& ahead, Evaluation& scratch) {
  cost.evaluate(s, ahead, Order::value, scratch);
  const double straight = scratch.value;
  Eigen::VectorXd bent = ahead;
  cost.set_step_base(s0, m0);
  cost.correct_step(s, bent);
  if (bent == ahead) return {straight, 1};
  cost.evaluate(s, bent, Order::value, scratch);
  const bool lower = scratch.value < straight || !std::isfinite(straight);
  if (!lower || !std::isfinite(scratch.value)) return {straight, 2};
  ahead = std::move(bent);
  return {scratch.value, 2};
}

}  // namespace legwright
