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

Eigen::SparseMatrix<double> Sparsity::build(int design_size, int motion_size,
                                            const std::vector<Clique*>& cliques) {
  std::vector<std::vector<int>> rows(motion_size);  // by column, lower triangle
  for (int k = 0; k < motion_size; ++k) rows[k].push_back(k);
  for (const Clique* clique : cliques)
    for (int b = 0; b < clique->motion_count; ++b)
      for (int a = b; a < clique->motion_count; ++a)
        rows[clique->slots[b] - design_size].push_back(clique->slots[a] - design_size);
  Eigen::SparseMatrix<double> pattern(motion_size, motion_size);
  std::vector<int> start(motion_size);
  int count = 0;
  for (int column = 0; column < motion_size; ++column) {
    std::sort(rows[column].begin(), rows[column].end());
    rows[column].erase(std::unique(rows[column].begin(), rows[column].end()), rows[column].end());
    start[column] = count;
    count += static_cast<int>(rows[column].size());
  }
  pattern.reserve(count);
  for (int column = 0; column < motion_size; ++column) {
    pattern.startVec(column);
    for (int row : rows[column]) pattern.insertBack(row, column) = 0.0;
  }
  pattern.finalize();
  for (Clique* clique : cliques) {
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
