// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/other_designs.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace legwright {
namespace {

DesignIteration iterate(double F) {
  DesignIteration out;
  out.value = F;
  out.tasks.resize(1);
  return out;
}

/// Starts "a", "b" … that ended with these F, the first of which is the best.
MultistartResult starts(const std::vector<double>& ends) {
  MultistartResult out;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    StartedRun run;
    run.label.start = std::string(1, static_cast<char>('a' + k));
    run.result.best = iterate(ends[k]);
    out.joint.push_back(std::move(run));
  }
  out.best = 0;
  return out;
}

TEST(OtherOptimum, IsTheLeastThatIsAnotherDesignAndNotTooDear) {
  const auto other = other_optimum(starts({1.0, 1.25, 1.005, 1.1, 1.4}), 1.3);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->name, "from d");
  EXPECT_EQ(other->design.value, 1.1);
}

TEST(OtherOptimum, IsNoneWhereAllStartsEndAlikeOrFarAbove) {
  EXPECT_FALSE(other_optimum(starts({1.0}), 1.3));
  EXPECT_FALSE(other_optimum(starts({1.0, 1.001, 1.31}), 1.3));
  EXPECT_FALSE(other_optimum(starts({1.0, std::numeric_limits<double>::quiet_NaN()}), 1.3));
}

TEST(FurtherCandidates, AreOtherEndsAndIteratesByRisingCost) {
  std::vector<DesignIteration> along;
  for (int k = 0; k < 13; ++k) along.push_back(iterate(20.0 - k));
  along[4] = iterate(std::numeric_limits<double>::infinity());
  const std::vector<Candidate> found = further_candidates(starts({1.0, 9.0, 1.005}), along);
  std::vector<std::string> names;
  for (const Candidate& candidate : found) names.push_back(candidate.name);
  EXPECT_EQ(names, (std::vector<std::string>{"from c", "from b", "iteration 10", "iteration 8",
                                             "iteration 6", "iteration 2"}));
}

}  // namespace
}  // namespace legwright
