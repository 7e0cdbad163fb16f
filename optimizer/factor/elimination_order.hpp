// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace legwright {

/// Lower triangle of a symmetric pattern by columns: rows of column j are rows[starts[j]] … below
/// rows[starts[j + 1]]. Entries of the upper triangle are allowed and mean their mirror images.
struct SymmetricPattern {
  std::vector<int> starts, rows;
  int size() const { return static_cast<int>(starts.size()) - 1; }
};

/// Orders worth a try, each a permutation (order[k] is eliminated k-th): approximate minimum degree
/// by CHOLMOD, from the first and from the last unknown on. (Its nested dissection was measured to
/// be 15 % worse for chains of knots, and not every CHOLMOD has it.) Throws std::bad_alloc.
std::vector<std::vector<int>> elimination_orders(const SymmetricPattern& pattern);

}  // namespace legwright
