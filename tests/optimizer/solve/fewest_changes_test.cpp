// SPDX-License-Identifier: Apache-2.0
// Designs with ever fewer changes.
#include "optimizer/solve/fewest_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "tests/optimizer/solve/toy_cost.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// Nine parameters, all of which the search changes.
class FewestChangesOfAToy : public testing::Test {
 protected:
  static constexpr int kParameters = 9;

  FewestChangesOfAToy() : space_(toy::box(0.6, kParameters)), old_(space_.initial()) {
    refit_.max_iterations = 60;
    refit_.value_tolerance = 1e-12;
    const CodesignResult found = codesign(tasks(1).front(), space_, old_, refit_);
    initial_ = found.initial.value;
    result_ = found.best;
    options_.codesign = refit_;
  }
  std::vector<std::vector<WeightedCost>> tasks(int threads) {
    std::vector<std::vector<WeightedCost>> out;
    for (int k = 0; k < threads; ++k) {
      costs_.push_back(std::make_unique<toy::CoupledCost>(toy::kMotionSize, kParameters));
      WeightedCost task;
      task.cost = costs_.back().get();
      task.initial_motion = VectorXd::Zero(toy::kMotionSize);
      out.push_back({task});
    }
    return out;
  }
  std::vector<FewerChanges> run(int threads) {
    const auto all = tasks(threads);
    return fewest_changes(all, space_, old_, initial_, result_, put_back(all, old_, result_),
                          options_);
  }
  /// The best design in which only these parameters change, from the old values on.
  double best_of(const std::vector<int>& changed) {
    DesignSpace space = space_;
    for (int k = 0; k < kParameters; ++k)
      if (std::find(changed.begin(), changed.end(), k) == changed.end())
        space.parameters[k].lower = space.parameters[k].upper = old_[k];
    return codesign(tasks(1).front(), space, old_, refit_).best.value;
  }

  const DesignSpace space_;
  const VectorXd old_;
  CodesignOptions refit_;
  FewestChangesOptions options_;
  std::vector<std::unique_ptr<toy::CoupledCost>> costs_;
  double initial_ = 0.0;
  DesignIteration result_;
};

TEST_F(FewestChangesOfAToy, EachDesignIsTheBestOfItsChanges) {
  const std::vector<FewerChanges> designs = run(1);
  ASSERT_EQ(designs.front().changed.size(), static_cast<std::size_t>(kParameters));
  ASSERT_EQ(designs.back().changed.size(), 1U);
  for (std::size_t k = 1; k < designs.size(); ++k) {
    const FewerChanges& each = designs[k];
    EXPECT_LT(each.changed.size(), designs[k - 1].changed.size());
    for (int i = 0; i < kParameters; ++i) {
      const bool changed =
          std::find(each.changed.begin(), each.changed.end(), i) != each.changed.end();
      EXPECT_EQ(changed, each.design.s[i] != old_[i]) << "others keep their bits";
    }
    EXPECT_NEAR(each.design.value, best_of(each.changed), 1e-6 * (initial_ - result_.value));
    EXPECT_GE(each.design.value, designs[k - 1].design.value - 1e-9);
  }
}

TEST_F(FewestChangesOfAToy, OneChangeIsNearTheBestOne) {
  double best = std::numeric_limits<double>::infinity(), worst = -best;
  for (int k = 0; k < kParameters; ++k) {
    best = std::min(best, best_of({k}));
    worst = std::max(worst, best_of({k}));
  }
  const double found = run(1).back().design.value;
  EXPECT_GE(found, best - 1e-9);
  EXPECT_LT(found, best + 0.25 * (worst - best)) << "greedy, but not blind";
}

TEST_F(FewestChangesOfAToy, BitsDoNotDependOnThreads) {
  const std::vector<FewerChanges> one = run(1), three = run(3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].changed, three[k].changed);
    EXPECT_EQ(one[k].design.s, three[k].design.s);
    EXPECT_EQ(one[k].design.value, three[k].design.value);
  }
}

TEST_F(FewestChangesOfAToy, AStopKeepsWhatIsThere) {
  options_.stop = [] { return true; };
  const std::vector<FewerChanges> designs = run(1);
  EXPECT_LT(designs.size(), run(1).front().changed.size());
  EXPECT_EQ(designs.front().design.s, result_.s);
}

// A stop leaves rows out of what put_back() hands back. Those that are there are no order of all
// changes: beyond their end lies memory of others.
TEST_F(FewestChangesOfAToy, RowsThatAreLeftOutAreAskedForAnew) {
  const std::vector<FewerChanges> whole = run(1);
  const auto all = tasks(1);
  std::vector<PutBack> rows = put_back(all, old_, result_);
  while (!rows.empty()) {
    rows.pop_back();
    options_.stop = nullptr;
    const auto designs = fewest_changes(all, space_, old_, initial_, result_, rows, options_);
    ASSERT_EQ(designs.size(), whole.size()) << rows.size() << " rows";
    for (std::size_t k = 0; k < designs.size(); ++k) {
      EXPECT_EQ(designs[k].changed, whole[k].changed) << rows.size() << " rows";
      EXPECT_EQ(designs[k].design.s, whole[k].design.s) << rows.size() << " rows";
    }
    options_.stop = [] { return true; };
    EXPECT_EQ(fewest_changes(all, space_, old_, initial_, result_, rows, options_).size(), 1U);
  }
}

TEST(FewestChanges, TheLastThatKeepsTheShareOfTheFall) {
  std::vector<FewerChanges> designs(4);
  for (const auto& [k, value] :
       {std::pair(0, 1.0), std::pair(1, 1.2), std::pair(2, 1.5), std::pair(3, 6.0)})
    designs[k].design.value = value;
  EXPECT_EQ(fewest_that_keep(designs, 11.0, 0.95), 2U) << "11 − 0.95 · 10 = 1.5";
  EXPECT_EQ(fewest_that_keep(designs, 11.0, 0.97), 1U);
  EXPECT_EQ(fewest_that_keep(designs, 11.0, 0.5), 3U);
  EXPECT_EQ(fewest_that_keep(designs, 11.0, 1.0), 0U);
}

}  // namespace
}  // namespace legwright
