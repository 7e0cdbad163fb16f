// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/supernodes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>
#include <set>

#include "tests/optimizer/factor/random_sparse.hpp"

namespace legwright {
namespace {

using Eigen::SparseMatrix;

/// Whether every entry of the dense factor has a place in a panel.
testing::AssertionResult covers(const Supernodes& nodes, const SparseMatrix<double>& lower) {
  const Eigen::MatrixXd a = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  const int size = static_cast<int>(a.rows());
  Eigen::MatrixXd permuted(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) permuted(i, j) = a(nodes.order[i], nodes.order[j]);
  const Eigen::MatrixXd factor = permuted.llt().matrixL();
  for (int node = 0; node < nodes.count(); ++node) {
    const std::set<int> rows(nodes.rows.begin() + nodes.row_start[node],
                             nodes.rows.begin() + nodes.row_start[node + 1]);
    for (int j = nodes.first[node]; j < nodes.first[node + 1]; ++j)
      for (int i = j; i < size; ++i)
        if (std::abs(factor(i, j)) > 1e-12 * factor(i, i) && !rows.count(i))
          return testing::AssertionFailure() << "L(" << i << ", " << j << ") has no place";
  }
  return testing::AssertionSuccess();
}

TEST(Supernodes, HaveAPlaceForEveryEntryOfTheFactor) {
  for (const int size : {1, 2, 9, 40, 90})
    for (const double density : {0.0, 0.8, 3.0, 200.0}) {
      const SparseMatrix<double> a =
          test::random_values(test::random_pattern(size, density, 7u + size), 3u);
      for (const std::vector<int>& order : elimination_orders(test::pattern_of(a))) {
        const Supernodes nodes = find_supernodes(test::pattern_of(a), order);
        std::vector<int> sorted = nodes.order, all(size);
        std::sort(sorted.begin(), sorted.end());
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(sorted, all) << "a permutation";
        EXPECT_EQ(nodes.first.back(), size);
        EXPECT_TRUE(covers(nodes, a)) << size << " unknowns, density " << density;
      }
    }
}

TEST(Supernodes, ALostRowIsNoticed) {
  const SparseMatrix<double> a = test::random_values(test::cyclic_pattern(6, 2), 3u);
  const SymmetricPattern pattern = test::pattern_of(a);
  Supernodes nodes = find_supernodes(pattern, elimination_orders(pattern).front());
  ASSERT_TRUE(covers(nodes, a));
  nodes.rows[nodes.row_start[1] - 1] = nodes.first[0];  // the last row of the first panel
  EXPECT_FALSE(covers(nodes, a));
}

TEST(Supernodes, OfADenseMatrixAreOne) {
  const SparseMatrix<double> a = test::random_values(test::random_pattern(20, 200.0, 1u), 1u);
  const SymmetricPattern pattern = test::pattern_of(a);
  const Supernodes nodes = find_supernodes(pattern, elimination_orders(pattern).front());
  EXPECT_EQ(nodes.count(), 1);
  EXPECT_TRUE(plan_updates(nodes).updates.empty());
}

// The reason for them: panels wide enough for fast kernels, without much more work.
TEST(Supernodes, OfAChainOfKnotsAreWide) {
  const SparseMatrix<double> a = test::cyclic_pattern(24, 12);
  const SymmetricPattern pattern = test::pattern_of(a);
  const Supernodes nodes = find_supernodes(pattern, elimination_orders(pattern).front());
  EXPECT_LE(nodes.count(), 24);
  const UpdatePlan plan = plan_updates(nodes);
  int rows = 0;
  for (const RowSegment& segment : plan.segments) rows += segment.length;
  EXPECT_GT(rows, 10 * static_cast<int>(plan.segments.size())) << "rows move in long runs";
}

}  // namespace
}  // namespace legwright
