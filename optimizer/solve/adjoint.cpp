// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/adjoint.hpp"

namespace legwright {

AdjointResult adjoint(HessianFactor& factor, const Eigen::SparseMatrix<double>& hessian_mm,
                      const Eigen::VectorXd& dJ_dm, const Eigen::MatrixXd& hessian_ms,
                      const Eigen::VectorXd& partial_J_s) {
  if (!factor.factor(hessian_mm, {})) return {};
  return adjoint(factor, dJ_dm, hessian_ms, partial_J_s);
}

AdjointResult adjoint(HessianFactor& exact, const Eigen::VectorXd& dJ_dm,
                      const Eigen::MatrixXd& hessian_ms, const Eigen::VectorXd& partial_J_s) {
  AdjointResult result;
  if (!exact.positive()) return result;
  const bool finite = dJ_dm.allFinite() && hessian_ms.allFinite() && partial_J_s.allFinite();
  if (!finite) {
    result.status = SolveStatus::not_finite;
    return result;
  }
  const bool solved = exact.solve(-dJ_dm, result.lambda);  // eq (7); ∂G/∂m is symmetric
  result.residual = exact.residual();
  if (!solved) return result;
  const Eigen::VectorXd total = hessian_ms.transpose() * result.lambda + partial_J_s;  // eq (8)
  if (!total.allFinite()) {
    result.status = SolveStatus::not_finite;
    return result;
  }
  result.dJ_ds = total;
  result.status = SolveStatus::converged;
  return result;
}

}  // namespace legwright
