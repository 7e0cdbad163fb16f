// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "optimizer/factor/elimination_order.hpp"
#include "optimizer/factor/kernel_table.hpp"

namespace legwright {

/// Columns of a Cholesky factor gathered into supernodes: neighbouring columns of (nearly) the same
/// structure, kept as one dense panel. Indices are positions in `order`, the order of elimination.
struct Supernodes {
  std::vector<int> order;      // order[k]: unknown eliminated k-th
  std::vector<int> first;      // first column of each supernode, and n
  std::vector<int> row_start;  // into `rows`
  std::vector<int> rows;       // rows of each panel, ascending: its own columns, then those below
  double predicted = 0.0;      // nanoseconds of a factorisation, by a crude model

  int count() const { return static_cast<int>(first.size()) - 1; }
  int columns(int j) const { return first[j + 1] - first[j]; }
  int height(int j) const { return row_start[j + 1] - row_start[j]; }
};

/// Supernodes of the factor under a given order, merged wherever that is predicted to save time.
Supernodes find_supernodes(const SymmetricPattern& pattern, const std::vector<int>& order);

/// What a panel subtracts from one of its ancestors.
struct PanelUpdate {
  int source;            // supernode
  int first_row;         // of the source panel; rows from there on take part
  int columns;           // so many of these rows are columns of the target
  std::size_t place;     // into UpdatePlan::places: row of the target panel of each such row
  std::size_t segments;  // into UpdatePlan::segments
  int segment_count;
};

/// All updates of a left-looking factorisation, grouped by target, sources ascending.
struct UpdatePlan {
  std::vector<std::size_t> start;  // target supernode → into `updates`
  std::vector<PanelUpdate> updates;
  std::vector<int> places;
  std::vector<RowSegment> segments;
};

UpdatePlan plan_updates(const Supernodes& nodes);

}  // namespace legwright
