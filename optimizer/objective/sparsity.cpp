// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/sparsity.hpp"

#include <algorithm>
#include <utility>

namespace legwright {

Clique::Clique(std::vector<int> clique_slots, int clique_motion_count)
    : slots(std::move(clique_slots)), motion_count(clique_motion_count) {
  for (int k = 0; k < motion_count; ++k) {
    if (k == 0 || slots[k] != slots[k - 1] + 1) segments.push_back({k, k});
    segments.back().end = k + 1;
    segment_of.push_back(static_cast<int>(segments.size()) - 1);
  }
}

namespace {

/// Rows of the lower triangle by column, rising: each column visits the cliques that it stands in.
std::vector<std::vector<int>> rows_by_column(int design_size, int motion_size,
                                             const std::vector<std::shared_ptr<Clique>>& cliques) {
  struct Place {
    const Clique* clique;
    int column;  // of the clique
  };
  std::vector<std::vector<Place>> places(static_cast<std::size_t>(motion_size));
  for (const auto& clique : cliques)
    for (int b = 0; b < clique->motion_count; ++b)
      places[static_cast<std::size_t>(clique->slots[b] - design_size)].push_back({clique.get(), b});
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(motion_size));
  std::vector<int> seen_by(static_cast<std::size_t>(motion_size), -1);  // row → last column
  for (int column = 0; column < motion_size; ++column) {
    std::vector<int>& own = rows[static_cast<std::size_t>(column)];
    own.push_back(column);
    seen_by[static_cast<std::size_t>(column)] = column;
    for (const Place& place : places[static_cast<std::size_t>(column)])
      for (int a = place.column + 1; a < place.clique->motion_count; ++a) {
        const int row = place.clique->slots[a] - design_size;
        int& seen = seen_by[static_cast<std::size_t>(row)];
        if (seen != column) own.push_back(row);
        seen = column;
      }
    std::sort(own.begin(), own.end());
  }
  return rows;
}

}  // namespace

Eigen::SparseMatrix<double> Sparsity::build(int design_size, int motion_size,
                                            const std::vector<std::shared_ptr<Clique>>& cliques) {
  const std::vector<std::vector<int>> rows = rows_by_column(design_size, motion_size, cliques);
  std::vector<int> start(motion_size);
  int count = 0;
  for (int column = 0; column < motion_size; ++column) {
    start[column] = count;
    count += static_cast<int>(rows[column].size());
  }
  Eigen::SparseMatrix<double> pattern(motion_size, motion_size);
  pattern.reserve(count);
  for (int column = 0; column < motion_size; ++column) {
    pattern.startVec(column);
    for (int row : rows[column]) pattern.insertBack(row, column) = 0.0;
  }
  pattern.finalize();
  for (const auto& clique : cliques) {
    clique->positions.clear();
    for (int b = 0; b < clique->motion_count; ++b)
      for (std::size_t g = clique->segment_of[b]; g < clique->segments.size(); ++g) {
        const int column = clique->slots[b] - design_size;
        const int row = clique->slots[std::max(b, clique->segments[g].start)] - design_size;
        const auto found = std::lower_bound(rows[column].begin(), rows[column].end(), row);
        clique->positions.push_back(start[column] + static_cast<int>(found - rows[column].begin()));
      }
  }
  return pattern;
}

}  // namespace legwright
