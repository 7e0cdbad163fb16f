// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/factor/elimination_order.hpp"

namespace legwright {

/// A way to factor A = H + diag(shift) that HessianFactor can use. It checks nothing: inputs are
/// finite and of the right size, the caller checks solutions.
class FactorBackend {
 public:
  virtual ~FactorBackend() = default;

  /// @param pattern of H; diagonal entries may be missing. Throws std::bad_alloc.
  virtual void analyse(const SymmetricPattern& pattern) = 0;

  /// @param values of H's entries in the order of the pattern, followed by 8 numbers of any value.
  /// @param diagonal of A and @param shift, both n × 1. Returns −1, or an unknown whose pivot is
  /// not finite or not above `tolerance` times its entry of `diagonal`: then there is no factor.
  virtual int factor(const double* values, const Eigen::VectorXd& diagonal,
                     const Eigen::VectorXd& shift, double tolerance) = 0;

  /// x ← A⁻¹ x.
  virtual void solve(Eigen::VectorXd& x) = 0;
  /// The same for each column of x. May grow its scratch memory.
  virtual void solve(Eigen::MatrixXd& x) = 0;
};

}  // namespace legwright
