// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <string>
#include <string_view>

#include "optimizer/factor/cpu_path.hpp"

namespace legwright {

/// How a Hessian is factored.
enum class FactorMethod {
  supernodal,  // our own LLᵀ, with kernels for the processor at hand
  simplicial,  // CHOLMOD's LDLᵀ, the reference; slower
};

/// supernodal or simplicial.
std::string_view to_string(FactorMethod method);

/// Supernodal, or the one that the environment variable LEGWRIGHT_FACTOR names. Throws
/// std::invalid_argument where it names none.
FactorMethod factor_method();

/// What a HessianFactor uses here: `avx512`, `avx2` or `baseline` (see CpuPath), or `simplicial`.
/// Bits of a result depend on it. Throws std::invalid_argument as factor_method() and cpu_path()
/// do.
std::string factor_name();

/// Cholesky factor of H + diag(shift): ordered and analysed once per pattern, factored many times
/// without allocating. Success of a factorisation means little (NaN may "succeed"), so inputs,
/// pivots, and every solution are checked. Same bits every run with one method and CpuPath. One
/// object per thread.
class HessianFactor {
 public:
  /// Takes factor_method() and cpu_path(), and throws what they throw.
  HessianFactor();
  /// @param path means something for `supernodal` only.
  explicit HessianFactor(FactorMethod method, CpuPath path = CpuPath::baseline);
  ~HessianFactor();
  HessianFactor(HessianFactor&&) noexcept;
  HessianFactor& operator=(HessianFactor&&) noexcept;

  /// Orders and analyses the pattern of `lower` (lower triangle, compressed; a missing diagonal is
  /// added). factor() does it by itself when the pattern is a new one. Throws std::bad_alloc.
  void analyse(const Eigen::SparseMatrix<double>& lower);

  /// Factors H + diag(shift_diagonal). @param lower n × n, lower triangle. @param shift_diagonal n
  /// × 1, or empty for none. Returns true only if all inputs are finite and every pivot is finite
  /// and clearly positive, measured by the diagonal entry that it came from. Stops at the first bad
  /// pivot, so an indefinite matrix costs less than a positive one.
  [[nodiscard]] bool factor(const Eigen::SparseMatrix<double>& lower,
                            const Eigen::VectorXd& shift_diagonal);

  /// Whether the last factor() returned true; nothing can be solved otherwise.
  bool positive() const;
  /// The unknown at whose pivot the last factor() stopped; −1 where it never came to one: success,
  /// or inputs that are not finite.
  int bad_pivot() const;

  /// Solves (H + diag(shift)) x = b. Returns false, with x = 0, where the factor is not positive, b
  /// or x is not finite, or the residual of the solution is too large. b and x may not be the same
  /// object.
  [[nodiscard]] bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  /// The same for every column of b, n × k, at about half the price per column. One bad column is
  /// enough for false and x = 0.
  [[nodiscard]] bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x);
  /// Residual of the last solve: max over rows |b − Ax| / (|A||x| + |b|), free of units.
  double residual() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace legwright
