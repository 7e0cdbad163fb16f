// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/elimination_order.hpp"

#include <cholmod.h>

#include <new>

namespace legwright {
namespace {

class Orderer {
 public:
  Orderer() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.try_catch = 1;
    common_.nmethods = 1;
    common_.postorder = 1;
  }
  ~Orderer() { cholmod_finish(&common_); }
  Orderer(const Orderer&) = delete;
  Orderer& operator=(const Orderer&) = delete;

  /// Empty where CHOLMOD lacks the method.
  std::vector<int> order(SymmetricPattern& pattern, int method) {
    common_.method[0].ordering = method;
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
    cholmod_factor* factor = cholmod_analyze(&a, &common_);
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    std::vector<int> result;
    if (factor) {
      const auto* permutation = static_cast<const int*>(factor->Perm);
      result.assign(permutation, permutation + pattern.size());
    }
    cholmod_free_factor(&factor, &common_);
    return result;
  }

 private:
  cholmod_common common_;
};

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
  Orderer orderer;
  SymmetricPattern copy = pattern, mirror = reversed(pattern);
  std::vector<std::vector<int>> orders = {orderer.order(copy, CHOLMOD_AMD),
                                          orderer.order(mirror, CHOLMOD_AMD),
                                          orderer.order(copy, CHOLMOD_METIS)};
  for (int& row : orders[1]) row = pattern.size() - 1 - row;
  std::erase_if(orders, [&](const auto& order) { return order.empty() && pattern.size() > 0; });
  return orders;
}

}  // namespace legwright
