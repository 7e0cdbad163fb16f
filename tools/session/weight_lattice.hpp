// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimizer/solve/multistart.hpp"

namespace legwright {

/// The best design that is known of one weighting of several tasks.
struct LatticePoint {
  std::vector<double> weights;  // of each task; they sum to 1
  DesignIteration best;
};

/// The trade-off between several tasks on a lattice of weights, as trade_off_front() is that of
/// two: corners are the optima of each task alone, with the motions of the others solved at their
/// design; every other point is solved from the design that is best at its weights of all that are
/// known, and anew while one of them is better than its own. Deterministic.
/// @param found the tasks solved alone, and designs of all tasks that are known
/// @param steps from corner to corner, at least 1
/// @return as far as options.go_on let it come; the first weight falls, then the second
[[nodiscard]] std::vector<LatticePoint> lattice_front(const std::vector<JointTask>& tasks,
                                                      const DesignSpace& space,
                                                      const MultistartResult& found, int steps,
                                                      const CodesignOptions& options);

}  // namespace legwright
