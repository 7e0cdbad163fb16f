// SPDX-License-Identifier: Apache-2.0
// What each change buys in the finished design: a changed parameter at its old value, the motion
// solved anew.
#include "optimizer/solve/put_back.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "optimizer/solve/newton.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// The puppy's body as it might be designed for two tasks: hips turned, one link longer.
class PutBackOfThePuppy : public testing::Test {
 protected:
  PutBackOfThePuppy()
      : walk_(puppy_.morphology, puppy_.space, test::make_sideways_task(false, 8)),
        trot_(puppy_.morphology, puppy_.space, test::make_sideways_task(true, 8)),
        old_(puppy_.space.initial()) {
    result_.s = old_;
    for (const auto& [k, by] : {std::pair(2, 0.006), std::pair(6, 0.4), std::pair(12, 0.5)})
      result_.s[k] += by;
    for (const Objective* objective : {&walk_, &trot_}) {
      TaskIterate task;
      task.m = solved(*objective, result_.s, test::standing_motion(*objective, result_.s));
      result_.tasks.push_back(task);
    }
  }
  static VectorXd solved(const Objective& objective, const VectorXd& s, VectorXd m) {
    EXPECT_EQ(newton(objective, s, m, {.tolerance = 1e-8, .max_iterations = 400}).status,
              SolveStatus::converged);
    return m;
  }
  /// The tasks for so many threads.
  std::vector<std::vector<WeightedCost>> tasks(int threads) {
    std::vector<std::vector<WeightedCost>> out;
    for (int k = 0; k < threads; ++k) {
      std::vector<WeightedCost>& own = out.emplace_back();
      for (const auto& [objective, weight] : {std::pair(&walk_, 0.75), std::pair(&trot_, 0.25)}) {
        costs_.push_back(std::make_unique<ObjectiveCost>(*objective));
        WeightedCost task;
        task.cost = costs_.back().get();
        task.weight = weight;
        own.push_back(task);
      }
    }
    return out;
  }

  const test::Puppy puppy_ = test::make_puppy(true);
  const Objective walk_, trot_;
  const VectorXd old_;
  DesignIteration result_;
  std::vector<std::unique_ptr<ObjectiveCost>> costs_;
};

TEST_F(PutBackOfThePuppy, CostsWhatAnIndependentSolveCosts) {
  const auto threads = tasks(1);
  const std::vector<PutBack> rows = put_back(threads, old_, result_);
  ASSERT_EQ(rows.size(), 3U) << "what did not change has no row";
  double sum = 0.0;
  for (const PutBack& row : rows) {
    VectorXd s = result_.s;
    s[row.parameter] = old_[row.parameter];
    EXPECT_EQ(row.s, s);
    EXPECT_EQ(row.motion_status, SolveStatus::converged);
    double weighted = 0.0;
    const Objective* objectives[] = {&walk_, &trot_};
    for (int i = 0; i < 2; ++i) {
      const VectorXd& m0 = result_.tasks[i].m;
      const VectorXd m = solved(*objectives[i], s, m0);
      const double fall = objectives[i]->evaluate(s, m, Order::value).value -
                          objectives[i]->evaluate(result_.s, m0, Order::value).value;
      EXPECT_GT(std::abs(fall), 1e-6) << "this shows nothing";
      EXPECT_NEAR(row.decrease[i], fall, 1e-6 * std::abs(fall) + 1e-9) << row.parameter;
      double terms = 0.0;
      for (const double term : row.terms[i]) terms += term;
      EXPECT_NEAR(terms, row.decrease[i], 1e-9 * std::abs(fall) + 1e-12);
      weighted += threads[0][i].weight * fall;
    }
    EXPECT_NEAR(row.total(threads[0]), weighted, 1e-6 * std::abs(weighted) + 1e-9);
    sum += row.total(threads[0]);
  }
  // All put back at once is another design than the sum of its parts: the rows do not add up.
  const VectorXd home = solved(walk_, old_, result_.tasks[0].m),
                 home_trot = solved(trot_, old_, result_.tasks[1].m);
  const double all = 0.75 * (walk_.evaluate(old_, home, Order::value).value -
                             walk_.evaluate(result_.s, result_.tasks[0].m, Order::value).value) +
                     0.25 * (trot_.evaluate(old_, home_trot, Order::value).value -
                             trot_.evaluate(result_.s, result_.tasks[1].m, Order::value).value);
  EXPECT_GT(std::abs(all - sum), 0.01 * std::abs(all));
}

TEST_F(PutBackOfThePuppy, BitsDoNotDependOnThreads) {
  const std::vector<PutBack> one = put_back(tasks(1), old_, result_);
  const std::vector<PutBack> three = put_back(tasks(3), old_, result_);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].parameter, three[k].parameter);
    EXPECT_EQ(one[k].decrease, three[k].decrease);
    EXPECT_EQ(one[k].terms, three[k].terms);
    EXPECT_EQ(one[k].motions, three[k].motions);
  }
}

TEST_F(PutBackOfThePuppy, RowsComeInOrderAndAStopLeavesTheRestOut) {
  PutBackOptions options;
  const std::vector<PutBack> rows = put_back(tasks(2), old_, result_, options);
  std::vector<int> seen;
  for (const PutBack& row : rows) {
    seen.push_back(row.parameter);
    EXPECT_EQ(row.motions.size(), 2U);
  }
  EXPECT_EQ(seen, (std::vector<int>{2, 6, 12}));
  int asked = 0;
  options.stop = [&] { return ++asked > 1; };
  EXPECT_EQ(put_back(tasks(1), old_, result_, options).size(), 1U);
  options.stop = {};
  options.limits.newton.go_on = [] { return false; };
  EXPECT_TRUE(put_back(tasks(1), old_, result_, options).empty()) << "motions left early";
  result_.s = old_;
  EXPECT_TRUE(put_back(tasks(1), old_, result_).empty()) << "nothing changed";
}

}  // namespace
}  // namespace legwright
