// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace legwright {

/// LDLᵀ of H + diag(shift): ordered and analysed once per pattern, factored many times. A library's
/// success means nothing here (indefinite and NaN matrices "succeed"), so inputs, D, and every
/// solution are checked. Same bits every run. One object per thread.
class HessianFactor {
 public:
  HessianFactor();
  ~HessianFactor();
  HessianFactor(HessianFactor&&) noexcept;
  HessianFactor& operator=(HessianFactor&&) noexcept;

  /// Orders and analyses the pattern of `lower` (lower triangle, compressed; a missing diagonal is
  /// added). factor() does it by itself when the pattern is a new one. Throws std::bad_alloc.
  void analyse(const Eigen::SparseMatrix<double>& lower);

  /// Factors H + diag(shift_diagonal). @param lower n × n, lower triangle. @param shift_diagonal n
  /// × 1, or empty for none. Returns true only if all inputs are finite and every entry of D is
  /// finite and clearly positive, measured by the diagonal entry that it came from.
  [[nodiscard]] bool factor(const Eigen::SparseMatrix<double>& lower,
                            const Eigen::VectorXd& shift_diagonal);

  /// Whether the last factor() returned true; nothing can be solved otherwise.
  bool positive() const;
  /// Entries of D in the last factorisation that are negative or not finite.
  int negative_count() const;

  /// Solves (H + diag(shift)) x = b. Returns false, with x = 0, where the factor is not positive, b
  /// or x is not finite, or the residual of the solution is too large. b and x may not be the same
  /// object.
  [[nodiscard]] bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  /// Residual of the last solve: max over rows |b − Ax| / (|A||x| + |b|), free of units.
  double residual() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace legwright
