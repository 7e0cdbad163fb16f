// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCore>
#include <cmath>
#include <random>
#include <vector>

#include "optimizer/factor/elimination_order.hpp"

namespace legwright::test {

/// Lower triangle with the given pattern, the diagonal added, and random entries; positive definite
/// by a diagonal `dominance` times the sum of its row. Rows and columns scaled over four decades,
/// as motions are.
inline Eigen::SparseMatrix<double> random_values(const Eigen::SparseMatrix<double>& pattern,
                                                 unsigned seed, double dominance = 1.02) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const int size = static_cast<int>(pattern.rows());
  std::vector<Eigen::Triplet<double>> triplets;
  Eigen::VectorXd row_sum = Eigen::VectorXd::Constant(size, 0.1), scale(size);
  for (double& s : scale) s = std::pow(10.0, 2.0 * entry(random));
  for (int j = 0; j < size; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(pattern, j); it; ++it) {
      const int i = static_cast<int>(it.row());
      if (i <= j) continue;
      const double value = entry(random);
      triplets.emplace_back(i, j, value * scale[i] * scale[j]);
      row_sum[i] += std::abs(value);
      row_sum[j] += std::abs(value);
    }
  for (int i = 0; i < size; ++i)
    triplets.emplace_back(i, i, dominance * row_sum[i] * scale[i] * scale[i]);
  Eigen::SparseMatrix<double> result(size, size);
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

/// Random lower pattern with about `per_column` entries below the diagonal of each column.
inline Eigen::SparseMatrix<double> random_pattern(int size, double per_column, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  std::vector<Eigen::Triplet<double>> triplets;
  for (int j = 0; j < size; ++j)
    for (int i = j + 1; i < size; ++i)
      if (chance(random) * (size - 1) < 2.0 * per_column) triplets.emplace_back(i, j, 1.0);
  Eigen::SparseMatrix<double> result(size, size);
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

/// A closed chain of knots, each of `block` unknowns, coupled with the next two.
inline Eigen::SparseMatrix<double> cyclic_pattern(int knots, int block) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int a = 0; a < knots; ++a)
    for (int b = 0; b < knots; ++b) {
      const int apart = (b - a + knots) % knots;
      if (apart > 2 && apart < knots - 2) continue;
      for (int i = 0; i < block; ++i)
        for (int j = 0; j < block; ++j)
          if (block * a + i >= block * b + j)
            triplets.emplace_back(block * a + i, block * b + j, 1.0);
    }
  Eigen::SparseMatrix<double> result(knots * block, knots * block);
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

inline SymmetricPattern pattern_of(const Eigen::SparseMatrix<double>& lower) {
  return {{lower.outerIndexPtr(), lower.outerIndexPtr() + lower.rows() + 1},
          {lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros()}};
}

}  // namespace legwright::test
