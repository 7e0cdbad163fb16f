// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>

#include "optimizer/factor/factor_backend.hpp"

namespace legwright {

/// LDLᵀ by CHOLMOD, column by column: the reference of SupernodalCholesky, independent of it and of
/// the processor. Always runs to the end.
class SimplicialLdlt final : public FactorBackend {
 public:
  SimplicialLdlt();
  ~SimplicialLdlt() override;

  void analyse(const SymmetricPattern& pattern) override;
  int factor(const double* values, const Eigen::VectorXd& diagonal, const Eigen::VectorXd& shift,
             double tolerance) override;
  void solve(Eigen::VectorXd& x) override;
  void solve(Eigen::MatrixXd& x) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace legwright
