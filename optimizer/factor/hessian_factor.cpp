// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/hessian_factor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "optimizer/factor/simplicial_ldlt.hpp"
#include "optimizer/factor/supernodal_cholesky.hpp"
#include "optimizer/factor/symmetric_residual.hpp"

namespace legwright {
namespace {

// A pivot below this share of its diagonal entry is rounding: the matrix is singular to working
// precision.
constexpr double kPivotTolerance = 64 * std::numeric_limits<double>::epsilon();
constexpr double kResidualTolerance = 1e-10;
constexpr double kRefineAbove = 1e-13;

std::unique_ptr<FactorBackend> make_backend(FactorMethod method, CpuPath path) {
  if (method == FactorMethod::simplicial) return std::make_unique<SimplicialLdlt>();
  return std::make_unique<SupernodalCholesky>(path);
}

/// A residual waits for memory: wider vectors than AVX2's were measured to gain nothing and, on one
/// virtual machine, to stall.
const CholeskyKernels& residual_kernels(CpuPath path) {
  return cholesky_kernels(path == CpuPath::avx512 ? CpuPath::avx2 : path);
}

}  // namespace

std::string_view to_string(FactorMethod method) {
  return method == FactorMethod::simplicial ? "simplicial" : "supernodal";
}

FactorMethod factor_method() {
  const char* wanted = std::getenv("LEGWRIGHT_FACTOR");
  if (!wanted || !*wanted) return FactorMethod::supernodal;
  for (const FactorMethod method : {FactorMethod::supernodal, FactorMethod::simplicial})
    if (wanted == to_string(method)) return method;
  throw std::invalid_argument("LEGWRIGHT_FACTOR is '" + std::string(wanted) +
                              "'; expected supernodal (which it is when unset) or simplicial");
}

std::string factor_name() {
  const FactorMethod method = factor_method();
  return std::string(method == FactorMethod::simplicial ? to_string(method)
                                                        : to_string(cpu_path()));
}

struct HessianFactor::Impl {
  Impl(FactorMethod method, CpuPath path)
      : backend(make_backend(method, path)),
        kernels(cholesky_kernels(path)),
        product(residual_kernels(path)) {}

  bool same_pattern(const Eigen::SparseMatrix<double>& lower) const {
    return analysed && lower.rows() == size &&
           lower.nonZeros() == static_cast<int>(pattern.rows.size()) &&
           std::equal(pattern.starts.begin(), pattern.starts.end(), lower.outerIndexPtr()) &&
           std::equal(pattern.rows.begin(), pattern.rows.end(), lower.innerIndexPtr());
  }
  bool take_shift(const Eigen::VectorXd& shift_diagonal);
  bool solve_checked(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  bool accept(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  std::unique_ptr<FactorBackend> backend;
  const CholeskyKernels& kernels;
  SymmetricResidual product;
  SymmetricPattern pattern;  // of H, to notice another one
  bool analysed = false;
  int size = 0;
  std::vector<double> values;  // of H as it was factored
  Eigen::VectorXd shift, diagonal, correction, column, column_solution;
  bool positive = false;
  int bad_pivot = -1;
  double residual = 0.0;
};

bool HessianFactor::Impl::take_shift(const Eigen::VectorXd& shift_diagonal) {
  if (shift_diagonal.size() == 0) {
    shift.setZero();
    return true;
  }
  if (shift_diagonal.size() != size || !shift_diagonal.allFinite()) return false;
  shift = shift_diagonal;
  return true;
}

// Checks x = A⁻¹ b by its backward error, and refines it once where that is needed.
bool HessianFactor::Impl::accept(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  double error = product.backward_error(values.data(), diagonal, b, x);
  if (error > kRefineAbove && std::isfinite(error)) {
    correction = product.remainder();
    backend->solve(correction);
    x += correction;
    error = product.backward_error(values.data(), diagonal, b, x);
  }
  residual = std::max(residual, error);
  return error <= kResidualTolerance && x.allFinite();
}

HessianFactor::HessianFactor() : HessianFactor(factor_method(), cpu_path()) {}
HessianFactor::HessianFactor(FactorMethod method, CpuPath path)
    : impl_(std::make_unique<Impl>(method, path)) {}
HessianFactor::~HessianFactor() = default;
HessianFactor::HessianFactor(HessianFactor&&) noexcept = default;
HessianFactor& HessianFactor::operator=(HessianFactor&&) noexcept = default;

void HessianFactor::analyse(const Eigen::SparseMatrix<double>& lower) {
  eigen_assert(lower.isCompressed() && lower.rows() == lower.cols());
  Impl& my = *impl_;
  my.analysed = my.positive = false;
  my.size = static_cast<int>(lower.rows());
  my.pattern.starts.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + my.size + 1);
  my.pattern.rows.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
  my.values.assign(my.pattern.rows.size() + 8, 0.0);
  my.product.analyse(my.pattern);
  my.backend->analyse(my.pattern);
  for (auto* v : {&my.shift, &my.diagonal, &my.correction, &my.column, &my.column_solution})
    v->setZero(my.size);
  my.analysed = true;
}

bool HessianFactor::factor(const Eigen::SparseMatrix<double>& lower,
                           const Eigen::VectorXd& shift_diagonal) {
  Impl& my = *impl_;
  if (!my.same_pattern(lower)) analyse(lower);
  my.positive = false;
  my.bad_pivot = -1;
  if (!my.take_shift(shift_diagonal)) return false;
  if (!my.kernels.copy_finite(lower.valuePtr(), static_cast<long>(my.pattern.rows.size()),
                              my.values.data()))
    return false;
  my.product.diagonal(my.values.data(), my.diagonal);
  my.diagonal += my.shift;
  my.bad_pivot = my.backend->factor(my.values.data(), my.diagonal, my.shift, kPivotTolerance);
  my.positive = my.bad_pivot < 0;
  return my.positive;
}

bool HessianFactor::positive() const { return impl_->positive; }
int HessianFactor::bad_pivot() const { return impl_->bad_pivot; }
double HessianFactor::residual() const { return impl_->residual; }

bool HessianFactor::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  Impl& my = *impl_;
  my.residual = std::numeric_limits<double>::infinity();
  if (my.positive && b.size() == my.size && b.allFinite()) {
    my.residual = 0.0;
    x = b;
    my.backend->solve(x);
    if (my.accept(b, x)) return true;
  }
  x.setZero(my.size);
  return false;
}

bool HessianFactor::solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) {
  Impl& my = *impl_;
  my.residual = std::numeric_limits<double>::infinity();
  if (my.positive && b.rows() == my.size && b.allFinite()) {
    my.residual = 0.0;
    x = b;
    my.backend->solve(x);
    bool good = true;
    for (int c = 0; c < b.cols() && good; ++c) {
      my.column = b.col(c);
      my.column_solution = x.col(c);
      good = my.accept(my.column, my.column_solution);
      x.col(c) = my.column_solution;
    }
    if (good) return true;
  }
  x.setZero(my.size, b.cols());
  return false;
}

}  // namespace legwright
