// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/factor/hessian_factor.hpp"

namespace legwright {

/// First-order motion of a changed design, eq (4): m + dm/ds Δs − H⁻¹G = m − H⁻¹(∂G/∂s Δs + G), one
/// solve. The last part is the Newton step that a loosely converged m still lacks.
/// Returns false, with `ahead` = m, where the factor cannot be used.
/// @param factor of ∂G/∂m at (s, m); a shifted one predicts less but still forward.
/// @param stationarity G at (s, m). @param design_change Δs.
[[nodiscard]] bool predict(HessianFactor& factor, const Eigen::VectorXd& m,
                           const Eigen::VectorXd& stationarity, const Eigen::MatrixXd& hessian_ms,
                           const Eigen::VectorXd& design_change, Eigen::VectorXd& ahead);

}  // namespace legwright
