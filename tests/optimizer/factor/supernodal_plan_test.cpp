// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/supernodal_plan.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/optimizer/factor/random_sparse.hpp"

namespace legwright {
namespace {

SymmetricPattern pattern_of(int blocks) {
  const Eigen::SparseMatrix<double> a = test::random_values(test::cyclic_pattern(blocks, 4), 1u);
  return {{a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1},
          {a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros()}};
}

void expect_same(const SupernodalPlan& a, const SupernodalPlan& b) {
  EXPECT_EQ(a.nodes.order, b.nodes.order);
  EXPECT_EQ(a.nodes.rows, b.nodes.rows);
  EXPECT_EQ(a.updates.places, b.updates.places);
  EXPECT_EQ(a.stride, b.stride);
  EXPECT_EQ(a.panel_start, b.panel_start);
  EXPECT_EQ(a.load_start, b.load_start);
  EXPECT_EQ(a.tallest, b.tallest);
  ASSERT_EQ(a.loads.size(), b.loads.size());
  for (std::size_t k = 0; k < a.loads.size(); ++k) {
    EXPECT_EQ(a.loads[k].source, b.loads[k].source);
    EXPECT_EQ(a.loads[k].target, b.loads[k].target);
    EXPECT_EQ(a.loads[k].step, b.loads[k].step);
    EXPECT_EQ(a.loads[k].length, b.loads[k].length);
  }
}

TEST(SupernodalPlan, OfAPatternIsMadeOnceAndIsWhatItWouldBeAnew) {
  const auto first = plan_of(pattern_of(6));
  EXPECT_EQ(plan_of(pattern_of(6)), first);
  EXPECT_NE(plan_of(pattern_of(7)), first);
  EXPECT_EQ(plan_of(pattern_of(6)), first) << "another one beside it";
  expect_same(*first, SupernodalPlan(pattern_of(6)));
}

TEST(SupernodalPlan, OfManyPatternsTheLastAreKept) {
  const auto first = plan_of(pattern_of(6));
  for (int blocks = 8; blocks < 20; ++blocks) (void)plan_of(pattern_of(blocks));
  const auto again = plan_of(pattern_of(6));
  EXPECT_NE(again, first) << "memory must not grow with every pattern";
  expect_same(*again, *first);
}

TEST(SupernodalPlan, AnyThreadMayAsk) {
  std::vector<std::shared_ptr<const SupernodalPlan>> found(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i)
    threads.emplace_back(
        [&found, i] { found[i] = plan_of(pattern_of(5 + static_cast<int>(i % 2))); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < found.size(); ++i)
    expect_same(*found[i], SupernodalPlan(pattern_of(5 + static_cast<int>(i % 2))));
}

}  // namespace
}  // namespace legwright
