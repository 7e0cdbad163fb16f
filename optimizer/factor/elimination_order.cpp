// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/elimination_order.hpp"

#include <cholmod.h>

#include <algorithm>
#include <new>

namespace legwright {
namespace {

/// Approximate minimum degree.
std::vector<int> minimum_degree(SymmetricPattern& pattern) {
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  common.try_catch = 1;
  common.nmethods = 1;
  common.postorder = 1;
  common.method[0].ordering = CHOLMOD_AMD;
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(pattern.size());
  a.nzmax = pattern.rows.size();
  a.p = pattern.starts.data();
  a.i = pattern.rows.data();
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  cholmod_factor* factor = cholmod_analyze(&a, &common);
  std::vector<int> order(factor ? pattern.size() : 0);
  if (factor) std::copy_n(static_cast<const int*>(factor->Perm), pattern.size(), order.begin());
  const bool failed = !factor;
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  if (failed) throw std::bad_alloc();
  return order;
}

/// The same matrix with its unknowns counted from the last one.
SymmetricPattern reversed(const SymmetricPattern& pattern) {
  const int size = pattern.size();
  std::vector<std::vector<int>> columns(size);
  for (int j = 0; j < size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k)
      columns[size - 1 - pattern.rows[k]].push_back(size - 1 - j);
  SymmetricPattern result;
  result.starts = {0};
  for (std::vector<int>& rows : columns) {
    result.rows.insert(result.rows.end(), rows.rbegin(), rows.rend());
    result.starts.push_back(static_cast<int>(result.rows.size()));
  }
  return result;
}

}  // namespace

std::vector<std::vector<int>> elimination_orders(const SymmetricPattern& pattern) {
  SymmetricPattern copy = pattern, mirror = reversed(pattern);
  std::vector<std::vector<int>> orders = {minimum_degree(copy), minimum_degree(mirror)};
  for (int& row : orders[1]) row = pattern.size() - 1 - row;
  return orders;
}

}  // namespace legwright
