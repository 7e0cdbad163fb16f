// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimizer/objective/element_plan.hpp"
#include "optimizer/terms/term.hpp"

namespace legwright {

/// Residuals of a term whose elements all are linear, r_row = offset + Σ coefficient ·
/// [s; m; y]_slot, one after another in memory; nothing for other terms.
struct LinearRows {
  struct Entry {
    int slot;
    double coefficient;
  };
  std::vector<Entry> entries;   // zeros left out
  std::vector<int> ends;        // row → where its entries end
  std::vector<double> offsets;  // row → r at zero
  std::vector<int> last_rows;   // element → where its rows end
  std::vector<char> constant;   // element → PlannedElement::constant
  std::vector<char> lone;       // element → whether it reaches one slot, which is of the motion

  bool empty() const { return last_rows.empty(); }
  int first_row(int element) const {
    return element > 0 ? last_rows[static_cast<std::size_t>(element) - 1] : 0;
  }
  /// Where a row's entries begin.
  const Entry* begin(int row) const {
    return entries.data() + (row > 0 ? ends[static_cast<std::size_t>(row) - 1] : 0);
  }
  const Entry* end(int row) const { return entries.data() + ends[static_cast<std::size_t>(row)]; }
  double residual(int row, const double* x) const {
    double sum = offsets[static_cast<std::size_t>(row)];
    for (const Entry* e = begin(row); e != end(row); ++e) sum += e->coefficient * x[e->slot];
    return sum;
  }
};

/// Of a term with constant Jacobians, else nothing. @param elements as they are planned
LinearRows linear_rows(const Term& term, const std::vector<PlannedElement>& elements);

}  // namespace legwright
