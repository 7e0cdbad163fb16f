// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace legwright {

/// A set of slots of p = [s; m] that couple: motion slots first, design slots last, both rising.
struct Clique {
  /// Consecutive motion slots: their rows are neighbours in every column of ∂G/∂m that the clique
  /// touches.
  struct Segment {
    int start, end;  // clique columns
  };

  Clique() = default;
  Clique(std::vector<int> clique_slots, int clique_motion_count);

  std::vector<int> slots;
  int motion_count = 0;
  std::vector<Segment> segments;  // of the motion slots
  std::vector<int> segment_of;    // motion column → segment
  /// Motion column by column, for the rest of its own segment and each later one: index among the
  /// values of ∂G/∂m of its first row at or below the diagonal.
  std::vector<int> positions;

  /// Calls visit(column, first row, row count, index among the values) for every run of the lower
  /// triangle.
  template <class Visit>
  void for_each_run(Visit visit) const {
    const int* position = positions.data();
    for (int b = 0; b < motion_count; ++b)
      for (std::size_t g = static_cast<std::size_t>(segment_of[b]); g < segments.size(); ++g) {
        const int first = b > segments[g].start ? b : segments[g].start;
        visit(b, first, segments[g].end - first, *position++);
      }
  }
};

/// The fixed pattern of ∂G/∂m: gait and morphology settle it, so it is built once and every
/// evaluation scatters straight into the value array.
class Sparsity {
 public:
  /// Fills in `positions` of each clique. @param design_size number of design slots, which come
  /// first in p.
  static Eigen::SparseMatrix<double> build(int design_size, int motion_size,
                                           const std::vector<std::shared_ptr<Clique>>& cliques);
};

}  // namespace legwright
