// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "optimizer/factor/cholesky_kernels.hpp"
#include "optimizer/factor/factor_backend.hpp"
#include "optimizer/factor/supernodal_plan.hpp"

namespace legwright {

/// LLᵀ by supernodes, left-looking: dense panels, each updated by those before it, with kernels for
/// the processor at hand. Stops at the first bad pivot. Takes the order of elimination that is
/// predicted to be fastest. Allocates in analyse() only.
class SupernodalCholesky final : public FactorBackend {
 public:
  explicit SupernodalCholesky(CpuPath path);

  void analyse(const SymmetricPattern& pattern) override;
  int factor(const double* values, const Eigen::VectorXd& diagonal, const Eigen::VectorXd& shift,
             double tolerance) override;
  void solve(Eigen::VectorXd& x) override;
  void solve(Eigen::MatrixXd& x) override;

  const Supernodes& supernodes() const { return plan_->nodes; }

 private:
  double* panel(int j) { return panels_.data() + plan_->panel_start[j]; }

  const CholeskyKernels* kernels_;
  std::shared_ptr<const SupernodalPlan> plan_;
  std::vector<double> panels_, least_pivot_, inverse_diagonal_;
  std::vector<double> x_, gathered_, many_, below_;
};

}  // namespace legwright
