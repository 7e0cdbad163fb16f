// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/simplicial_ldlt.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <tuple>
#include <vector>

namespace legwright {
namespace {

cholmod_sparse view(SymmetricPattern& pattern, double* values, int stype) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(pattern.size());
  a.nzmax = pattern.rows.size();
  a.p = pattern.starts.data();
  a.i = pattern.rows.data();
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
struct SimplicialLdlt::Impl {
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

  cholmod_factor* analyse(SymmetricPattern& pattern, int stype, int ordering) {
    common.method[0].ordering = ordering;
    common.postorder = ordering == CHOLMOD_AMD;
    cholmod_sparse a = view(pattern, nullptr, stype);
    cholmod_factor* result = cholmod_analyze(&a, &common);
    if (!result || common.status < CHOLMOD_OK) {
      cholmod_free_factor(&result, &common);
      throw std::bad_alloc();
    }
    return result;
  }

  void build_map(const SymmetricPattern& pattern);
  int first_bad_pivot(double tolerance) const;

  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense *x = nullptr, *y = nullptr,
                *e = nullptr;  // CHOLMOD's solution and work space, kept
  std::vector<int> place;      // place[i]: row i of H in the permuted matrix
  SymmetricPattern upper;      // permuted upper triangle
  std::vector<double> values;  // its entries
  std::vector<int> target;     // H's k-th entry → values
  std::vector<int> diagonal;   // permuted diagonal j → values
  Eigen::VectorXd rhs;
};

void SimplicialLdlt::Impl::build_map(const SymmetricPattern& pattern) {
  struct Entry {
    int row, column, source;  // source −1: a diagonal entry that H may lack
  };
  const int size = pattern.size();
  std::vector<Entry> entries;
  for (int j = 0; j < size; ++j) {
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      const int a = place[pattern.rows[k]], b = place[j];
      entries.push_back({std::min(a, b), std::max(a, b), k});
    }
    entries.push_back({j, j, -1});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.column, a.row, a.source) < std::tie(b.column, b.row, b.source);
  });
  upper.starts.assign(size + 1, 0);
  upper.rows.clear();
  target.assign(pattern.rows.size(), 0);
  diagonal.assign(size, 0);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Entry& entry = entries[k];
    const bool repeated =
        k > 0 && entries[k - 1].column == entry.column && entries[k - 1].row == entry.row;
    if (!repeated) {
      upper.rows.push_back(entry.row);
      ++upper.starts[entry.column + 1];
    }
    const int at = static_cast<int>(upper.rows.size()) - 1;
    if (entry.source >= 0) target[entry.source] = at;
    if (entry.row == entry.column) diagonal[entry.column] = at;
  }
  for (int j = 0; j < size; ++j) upper.starts[j + 1] += upper.starts[j];
  values.assign(upper.rows.size(), 0.0);
}

int SimplicialLdlt::Impl::first_bad_pivot(double tolerance) const {
  const auto* start = static_cast<const int*>(factor->p);
  const auto* entry = static_cast<const double*>(factor->x);
  for (std::size_t j = 0; j < diagonal.size(); ++j) {
    const double pivot = entry[start[j]];
    if (!(pivot > tolerance * values[diagonal[j]]) || !std::isfinite(pivot))
      return static_cast<int>(j);
  }
  return -1;
}

SimplicialLdlt::SimplicialLdlt() : impl_(std::make_unique<Impl>()) {}
SimplicialLdlt::~SimplicialLdlt() = default;

void SimplicialLdlt::analyse(const SymmetricPattern& pattern) {
  Impl& my = *impl_;
  my.release();
  SymmetricPattern lower = pattern;
  cholmod_factor* ordered = my.analyse(lower, -1, CHOLMOD_AMD);
  const auto* order = static_cast<const int*>(ordered->Perm);
  my.place.assign(pattern.size(), 0);
  for (int k = 0; k < pattern.size(); ++k) my.place[order[k]] = k;
  cholmod_free_factor(&ordered, &my.common);
  my.build_map(pattern);
  my.factor = my.analyse(my.upper, 1, CHOLMOD_NATURAL);
  my.rhs.setZero(pattern.size());
}

int SimplicialLdlt::factor(const double* values, const Eigen::VectorXd&,
                           const Eigen::VectorXd& shift, double tolerance) {
  Impl& my = *impl_;
  if (my.values.empty()) return -1;  // CHOLMOD has no factor of nothing
  std::fill(my.values.begin(), my.values.end(), 0.0);
  for (std::size_t k = 0; k < my.target.size(); ++k) my.values[my.target[k]] += values[k];
  for (int i = 0; i < shift.size(); ++i) my.values[my.diagonal[my.place[i]]] += shift[i];
  cholmod_sparse a = view(my.upper, my.values.data(), 1);
  // Indefinite is an answer, not an error; only a lack of memory is one.
  cholmod_factorize(&a, my.factor, &my.common);
  if (my.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  const bool usable = my.common.status >= CHOLMOD_OK && my.factor->xtype == CHOLMOD_REAL;
  const int bad = usable ? my.first_bad_pivot(tolerance) : 0;
  if (bad < 0) return -1;
  return static_cast<int>(std::find(my.place.begin(), my.place.end(), bad) - my.place.begin());
}

void SimplicialLdlt::solve(Eigen::VectorXd& x) {
  Impl& my = *impl_;
  if (x.size() == 0) return;
  for (int i = 0; i < x.size(); ++i) my.rhs[my.place[i]] = x[i];
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = static_cast<std::size_t>(x.size());
  right.ncol = 1;
  right.x = my.rhs.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_LDLt, my.factor, &right, nullptr, &my.x, nullptr, &my.y, &my.e,
                      &my.common))
    throw std::bad_alloc();
  const auto* solution = static_cast<const double*>(my.x->x);
  for (int i = 0; i < x.size(); ++i) x[i] = solution[my.place[i]];
}

void SimplicialLdlt::solve(Eigen::MatrixXd& x) {
  for (int c = 0; c < x.cols(); ++c) {
    Eigen::VectorXd column = x.col(c);
    solve(column);
    x.col(c) = column;
  }
}

}  // namespace legwright
