// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "optimizer/factor/cholesky_kernels.hpp"
#include "optimizer/factor/factor_backend.hpp"
#include "optimizer/factor/supernodes.hpp"

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

  const Supernodes& supernodes() const { return nodes_; }

 private:
  // Neighbouring values of H that go down a column of a panel, or along a row of it.
  struct Load {
    int source, target, step, length;
  };
  void plan_loads(const SymmetricPattern& pattern);
  double* panel(int j) { return panels_.data() + panel_start_[j]; }

  const CholeskyKernels* kernels_;
  Supernodes nodes_;
  UpdatePlan plan_;
  std::vector<int> stride_;
  std::vector<std::size_t> panel_start_, load_start_;
  std::vector<Load> loads_;
  std::vector<double> panels_, least_pivot_, inverse_diagonal_;
  std::vector<double> x_, gathered_, many_, below_;
};

}  // namespace legwright
