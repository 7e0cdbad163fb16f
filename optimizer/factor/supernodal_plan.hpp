// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "optimizer/factor/elimination_order.hpp"
#include "optimizer/factor/supernodes.hpp"

namespace legwright {

/// All that a supernodal factorisation takes from the pattern of H alone: the order of elimination
/// that is predicted to be fastest, its panels, and where each value of H goes.
struct SupernodalPlan {
  // Neighbouring values of H that go down a column of a panel, or along a row of it.
  struct Load {
    int source, target, step, length;
  };

  explicit SupernodalPlan(const SymmetricPattern& pattern);

  Supernodes nodes;
  UpdatePlan updates;
  std::vector<int> stride;               // of the columns of each panel
  std::vector<std::size_t> panel_start;  // of each panel, and the end of the last
  std::vector<std::size_t> load_start;   // panel → loads
  std::vector<Load> loads;
  int tallest = 0;  // rows of the panel that has most

 private:
  void plan_panels();
  void plan_loads(const SymmetricPattern& pattern);
};

/// The plan of a pattern. Searches that follow each other, and the solvers of one search, ask for
/// the same few: the last ones are kept, and shared. Any thread may ask. Throws std::bad_alloc.
std::shared_ptr<const SupernodalPlan> plan_of(const SymmetricPattern& pattern);

}  // namespace legwright
