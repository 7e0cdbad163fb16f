// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/predictor.hpp"

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

}  // namespace legwright
