// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/hessian_factor.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

namespace legwright {
namespace {

// A pivot below this share of its diagonal entry is rounding: the matrix is singular to working
// precision.
constexpr double pivot_tolerance = 64 * std::numeric_limits<double>::epsilon();
constexpr double residual_tolerance = 1e-10;
constexpr double refine_above = 1e-13;

cholmod_sparse view(int size, std::vector<int>& starts, std::vector<int>& rows, double* values,
                    int stype) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(size);
  a.nzmax = rows.size();
  a.p = starts.data();
  a.i = rows.data();
  a.x = values;
  a.stype = stype;
  a.itype = CHOLMOD_INT;
  a.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  return a;
}

}  // namespace

// The matrix is permuted here, once, through a map, and handed to CHOLMOD in its natural order as
// an upper triangle: the one form that it factors without copying, hence without allocating.
struct HessianFactor::Impl {
  Impl() {
    cholmod_start(&common);
    common.print = 0;
    common.try_catch = 1;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.final_ll = 0;
    common.nmethods = 1;
  }
  ~Impl() {
    release();
    cholmod_finish(&common);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void release() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_dense(&x, &common);
    cholmod_free_dense(&y, &common);
    cholmod_free_dense(&e, &common);
  }

  cholmod_factor* analyse(std::vector<int>& column_starts, std::vector<int>& row_indices, int stype,
                          int ordering) {
    common.method[0].ordering = ordering;
    common.postorder = ordering == CHOLMOD_AMD;
    cholmod_sparse a = view(size, column_starts, row_indices, nullptr, stype);
    cholmod_factor* result = cholmod_analyze(&a, &common);
    if (!result || common.status < CHOLMOD_OK) {
      cholmod_free_factor(&result, &common);
      throw std::bad_alloc();
    }
    return result;
  }

  bool same_pattern(const Eigen::SparseMatrix<double>& lower) const {
    return factor && lower.rows() == size &&
           lower.nonZeros() == static_cast<int>(input_rows.size()) &&
           std::equal(input_starts.begin(), input_starts.end(), lower.outerIndexPtr()) &&
           std::equal(input_rows.begin(), input_rows.end(), lower.innerIndexPtr());
  }

  void build_map();
  void inspect_pivots();
  void solve_permuted(const Eigen::VectorXd& b);
  double backward_error(const Eigen::VectorXd& b);

  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense *x = nullptr, *y = nullptr,
                *e = nullptr;  // CHOLMOD's solution and work space, kept
  int size = 0;
  std::vector<int> input_starts, input_rows;  // pattern of H, to notice another one
  std::vector<int> place;                     // place[i]: row i of H in the permuted matrix
  std::vector<int> starts, rows;              // permuted upper triangle
  std::vector<double> values;
  std::vector<int> target, diagonal;  // H's k-th entry → values; permuted diagonal j → values
  Eigen::VectorXd rhs, solution, remainder, magnitude;
  bool positive = false;
  int negative_count = 0;
  double residual = 0.0;
};

void HessianFactor::Impl::build_map() {
  struct Entry {
    int row, column, source;  // source −1: a diagonal entry that H may lack
  };
  std::vector<Entry> entries;
  for (int j = 0; j < size; ++j) {
    for (int k = input_starts[j]; k < input_starts[j + 1]; ++k) {
      const int a = place[input_rows[k]], b = place[j];
      entries.push_back({std::min(a, b), std::max(a, b), k});
    }
    entries.push_back({j, j, -1});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.column, a.row, a.source) < std::tie(b.column, b.row, b.source);
  });
  starts.assign(size + 1, 0);
  rows.clear();
  target.assign(input_rows.size(), 0);
  diagonal.assign(size, 0);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Entry& entry = entries[k];
    const bool repeated =
        k > 0 && entries[k - 1].column == entry.column && entries[k - 1].row == entry.row;
    if (!repeated) {
      rows.push_back(entry.row);
      ++starts[entry.column + 1];
    }
    const int at = static_cast<int>(rows.size()) - 1;
    if (entry.source >= 0) target[entry.source] = at;
    if (entry.row == entry.column) diagonal[entry.column] = at;
  }
  for (int j = 0; j < size; ++j) starts[j + 1] += starts[j];
  values.assign(rows.size(), 0.0);
}

void HessianFactor::Impl::inspect_pivots() {
  const auto* start = static_cast<const int*>(factor->p);
  const auto* entry = static_cast<const double*>(factor->x);
  positive = true;
  negative_count = 0;
  for (int j = 0; j < size; ++j) {
    const double pivot = entry[start[j]];
    if (!(pivot >= 0.0) || !std::isfinite(pivot)) ++negative_count;
    if (!(pivot > pivot_tolerance * values[diagonal[j]]) || !std::isfinite(pivot)) positive = false;
  }
}

void HessianFactor::Impl::solve_permuted(const Eigen::VectorXd& b) {
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = static_cast<std::size_t>(size);
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());  // CHOLMOD only reads it
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_LDLt, factor, &right, nullptr, &x, nullptr, &y, &e, &common))
    throw std::bad_alloc();
}

// Leaves b − A·solution in `remainder`. Rows are weighed by what they are made of, so that newtons
// and radians count alike.
double HessianFactor::Impl::backward_error(const Eigen::VectorXd& b) {
  remainder = b;
  magnitude = b.cwiseAbs();
  for (int j = 0; j < size; ++j) {
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const int i = rows[k];
      const double right = values[k] * solution[j];
      remainder[i] -= right;
      magnitude[i] += std::abs(right);
      if (i == j) continue;
      const double mirrored = values[k] * solution[i];
      remainder[j] -= mirrored;
      magnitude[j] += std::abs(mirrored);
    }
  }
  double worst = 0.0;
  for (int i = 0; i < size; ++i) {
    if (!std::isfinite(remainder[i]) || !std::isfinite(magnitude[i]))
      return std::numeric_limits<double>::infinity();
    if (magnitude[i] > 0.0) worst = std::max(worst, std::abs(remainder[i]) / magnitude[i]);
  }
  return worst;
}

HessianFactor::HessianFactor() : impl_(std::make_unique<Impl>()) {}
HessianFactor::~HessianFactor() = default;
HessianFactor::HessianFactor(HessianFactor&&) noexcept = default;
HessianFactor& HessianFactor::operator=(HessianFactor&&) noexcept = default;

void HessianFactor::analyse(const Eigen::SparseMatrix<double>& lower) {
  eigen_assert(lower.isCompressed() && lower.rows() == lower.cols());
  Impl& my = *impl_;
  my.release();
  my.positive = false;
  my.size = static_cast<int>(lower.rows());
  my.input_starts.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + my.size + 1);
  my.input_rows.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());

  cholmod_factor* ordered = my.analyse(my.input_starts, my.input_rows, -1, CHOLMOD_AMD);
  const auto* order = static_cast<const int*>(ordered->Perm);
  my.place.assign(my.size, 0);
  for (int k = 0; k < my.size; ++k) my.place[order[k]] = k;
  cholmod_free_factor(&ordered, &my.common);

  my.build_map();
  my.factor = my.analyse(my.starts, my.rows, 1, CHOLMOD_NATURAL);
  for (auto* v : {&my.rhs, &my.solution, &my.remainder, &my.magnitude}) v->setZero(my.size);
}

bool HessianFactor::factor(const Eigen::SparseMatrix<double>& lower,
                           const Eigen::VectorXd& shift_diagonal) {
  Impl& my = *impl_;
  if (!my.same_pattern(lower)) analyse(lower);
  my.positive = false;
  my.negative_count = my.size;
  if (shift_diagonal.size() != 0 &&
      (shift_diagonal.size() != my.size || !shift_diagonal.allFinite()))
    return false;
  std::fill(my.values.begin(), my.values.end(), 0.0);
  const double* entry = lower.valuePtr();
  for (std::size_t k = 0; k < my.target.size(); ++k) {
    if (!std::isfinite(entry[k])) return false;
    my.values[my.target[k]] += entry[k];
  }
  for (int i = 0; i < shift_diagonal.size(); ++i)
    my.values[my.diagonal[my.place[i]]] += shift_diagonal[i];
  cholmod_sparse a = view(my.size, my.starts, my.rows, my.values.data(), 1);
  // Indefinite is an answer, not an error; only a lack of memory is one.
  cholmod_factorize(&a, my.factor, &my.common);
  if (my.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (my.common.status < CHOLMOD_OK || my.factor->xtype != CHOLMOD_REAL) return false;
  my.inspect_pivots();
  return my.positive;
}

bool HessianFactor::positive() const { return impl_->positive; }
int HessianFactor::negative_count() const { return impl_->negative_count; }
double HessianFactor::residual() const { return impl_->residual; }

bool HessianFactor::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  Impl& my = *impl_;
  x.setZero(my.size);
  my.residual = std::numeric_limits<double>::infinity();
  if (!my.positive || b.size() != my.size || !b.allFinite()) return false;
  for (int i = 0; i < my.size; ++i) my.rhs[my.place[i]] = b[i];
  my.solve_permuted(my.rhs);
  my.solution = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(my.x->x), my.size);
  my.residual = my.backward_error(my.rhs);
  if (my.residual > refine_above && std::isfinite(my.residual)) {
    my.solve_permuted(my.remainder);
    my.solution += Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(my.x->x), my.size);
    my.residual = my.backward_error(my.rhs);
  }
  if (!(my.residual <= residual_tolerance) || !my.solution.allFinite()) return false;
  for (int i = 0; i < my.size; ++i) x[i] = my.solution[my.place[i]];
  return true;
}

}  // namespace legwright
