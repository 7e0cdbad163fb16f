// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/solve/status.hpp"

namespace legwright {

struct AdjointResult {
  SolveStatus status = SolveStatus::not_a_minimum;  // or `converged`, or `not_finite`
  Eigen::VectorXd lambda;                           // adjoint variables, motion_size × 1
  Eigen::VectorXd dJ_ds;                            // design_size × 1; empty unless `converged`
  double residual = 0.0;  // of eq (7), per row, free of units (HessianFactor::residual)
};

/// Eqs (7), (8): solves (∂G/∂m)ᵀλ = −(∂J/∂m)ᵀ, then dJ/ds = λᵀ∂G/∂s + ∂J/∂s, for any outer cost J.
/// One solve, whatever the number of design parameters. Where G ≠ 0 it is the derivative along the
/// manifold G(s, m) = const through (s, m). With J = F pass the stationarity and partial_s; λ is
/// then the Newton step. Uses the exact Hessian, never a shifted one: `not_a_minimum` where that is
/// not positive definite.
/// @param hessian_mm ∂G/∂m, lower triangle. @param dJ_dm motion_size × 1. @param hessian_ms ∂G/∂s.
/// @param partial_J_s ∂J/∂s at fixed m.
[[nodiscard]] AdjointResult adjoint(HessianFactor& factor,
                                    const Eigen::SparseMatrix<double>& hessian_mm,
                                    const Eigen::VectorXd& dJ_dm, const Eigen::MatrixXd& hessian_ms,
                                    const Eigen::VectorXd& partial_J_s);

/// The same with a factor of the exact Hessian already at hand (SolveReport::exact_factor).
[[nodiscard]] AdjointResult adjoint(HessianFactor& exact, const Eigen::VectorXd& dJ_dm,
                                    const Eigen::MatrixXd& hessian_ms,
                                    const Eigen::VectorXd& partial_J_s);

}  // namespace legwright
