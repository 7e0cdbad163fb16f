// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/solve/cost_function.hpp"

namespace legwright {

/// First-order motion of a changed design, eq (4): m + dm/ds Δs − H⁻¹G = m − H⁻¹(∂G/∂s Δs + G), one
/// solve. The last part is the Newton step that a loosely converged m still lacks.
/// Returns false, with `ahead` = m, where the factor cannot be used.
/// @param factor of ∂G/∂m at (s, m); a shifted one predicts less but still forward.
/// @param stationarity G at (s, m). @param design_change Δs.
[[nodiscard]] bool predict(HessianFactor& factor, const Eigen::VectorXd& m,
                           const Eigen::VectorXd& stationarity, const Eigen::MatrixXd& hessian_ms,
                           const Eigen::VectorXd& design_change, Eigen::VectorXd& ahead);

/// F of a prediction, and how often F was evaluated for it.
struct PredictedValue {
  double value = 0.0;
  int evaluations = 0;
};

/// Bends a predicted motion as CostFunction::correct_step() does, where that has less F: feet and
/// COM of a first-order motion miss their pose by what is quadratic in the design change.
/// @param s0 design and @param m0 motion that it was predicted from @param s design of `ahead`
[[nodiscard]] PredictedValue bend_prediction(CostFunction& cost, const Eigen::VectorXd& s0,
                                             const Eigen::VectorXd& m0, const Eigen::VectorXd& s,
                                             Eigen::VectorXd& ahead, Evaluation& scratch);

}  // namespace legwright
