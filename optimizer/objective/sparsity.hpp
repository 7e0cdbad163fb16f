// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace legwright {

/// A set of slots of p = [s; m] that couple: motion slots first, design slots last.
struct Clique {
  std::vector<int> slots;
  int motion_count = 0;
  /// Entry (row, column), row ≥ column, of the clique's motion block → index into the values of ∂G/∂m.
  std::vector<int> positions;

  int position(int row, int column) const { return positions[row * (row + 1) / 2 + column]; }
};

/// The fixed pattern of ∂G/∂m: gait and morphology settle it, so it is built once and every evaluation
/// scatters straight into the value array.
class Sparsity {
 public:
  /// Fills in `positions` of each clique. @param design_size number of design slots, which come first in p.
  static Eigen::SparseMatrix<double> build(int design_size, int motion_size,
                                           const std::vector<Clique*>& cliques);
};

}  // namespace legwright
