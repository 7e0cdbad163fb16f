// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/factor/cholesky_kernels.hpp"
#include "optimizer/factor/elimination_order.hpp"

namespace legwright {

/// b − Ax and how large it is, for a sparse symmetric A of fixed pattern. Allocates in analyse()
/// only.
class SymmetricResidual {
 public:
  explicit SymmetricResidual(const CholeskyKernels& kernels) : kernels_(&kernels) {}

  void analyse(const SymmetricPattern& pattern);

  /// The diagonal among `values`, which are in the order of the pattern.
  void diagonal(const double* values, Eigen::VectorXd& out) const;

  /// Max over rows of |b − Ax| / (|A||x| + |b|): rows are weighed by what they are made of, so that
  /// newtons and radians count alike. Infinite where anything is not finite. @param diagonal of A,
  /// in the place of the one among `values`.
  double backward_error(const double* values, const Eigen::VectorXd& diagonal,
                        const Eigen::VectorXd& b, const Eigen::VectorXd& x);
  /// b − Ax of the last backward_error().
  Eigen::Ref<const Eigen::VectorXd> remainder() const { return remainder_.head(size_); }

 private:
  const CholeskyKernels* kernels_;
  int size_ = 0;
  std::vector<int> run_start_;  // column → runs_, the diagonal left out
  std::vector<ColumnRun> runs_;
  struct Diagonal {
    int unknown, value;
  };
  std::vector<Diagonal> diagonal_;
  Eigen::VectorXd x_, remainder_, magnitude_;  // longer than n: kernels read whole vectors
};

}  // namespace legwright
