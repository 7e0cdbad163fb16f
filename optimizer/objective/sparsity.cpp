// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/sparsity.hpp"

#include <algorithm>

namespace legwright {

Eigen::SparseMatrix<double> Sparsity::build(int design_size, int motion_size,
                                            const std::vector<Clique*>& cliques) {
  std::vector<std::vector<int>> rows(motion_size);  // by column, lower triangle
  for (int k = 0; k < motion_size; ++k) rows[k].push_back(k);
  const auto entry = [&](const Clique& clique, int a, int b) {
    const int i = clique.slots[a] - design_size, j = clique.slots[b] - design_size;
    return std::pair(std::max(i, j), std::min(i, j));
  };
  for (const Clique* clique : cliques)
    for (int a = 0; a < clique->motion_count; ++a)
      for (int b = 0; b <= a; ++b) {
        const auto [row, column] = entry(*clique, a, b);
        rows[column].push_back(row);
      }
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
    for (int a = 0; a < clique->motion_count; ++a)
      for (int b = 0; b <= a; ++b) {
        const auto [row, column] = entry(*clique, a, b);
        const auto found = std::lower_bound(rows[column].begin(), rows[column].end(), row);
        clique->positions.push_back(start[column] + static_cast<int>(found - rows[column].begin()));
      }
  }
  return pattern;
}

}  // namespace legwright
