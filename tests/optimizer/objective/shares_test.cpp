// SPDX-License-Identifier: Apache-2.0
// Each term's share of the derivatives: shares sum to the whole and follow the weights.
#include <gtest/gtest.h>

#include <random>

#include "optimizer/objective/objective.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

struct Moving {
  explicit Moving(const Task& task)
      : puppy(test::make_puppy(true)), objective(puppy.morphology, puppy.space, task) {
    s = puppy.space.initial();
    m = initial_guess(objective, s);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < m.size(); ++k) m[k] += 0.02 * objective.motion_units()[k] * normal(random);
    for (int k = 0; k < s.size(); ++k) s[k] *= 1.0 + 0.01 * normal(random);
  }
  test::Puppy puppy;
  Objective objective;
  VectorXd s, m;
};

TEST(TermShares, SumToTheDerivativesOfTheWhole) {
  const Moving at(test::make_sideways_task(true, 8));
  const Evaluation whole = at.objective.evaluate(at.s, at.m, Order::design);
  const TermShares shares = at.objective.shares(at.s, at.m, true);
  ASSERT_EQ(shares.names, at.objective.term_names());
  EXPECT_LT((shares.partial_s.colwise().sum().transpose() - whole.partial_s).norm(),
            1e-12 * whole.partial_s.norm());
  EXPECT_LT((shares.stationarity.colwise().sum().transpose() - whole.stationarity).norm(),
            1e-12 * whole.stationarity.norm());
  EXPECT_GT(whole.partial_s.norm(), 0.0);
}

TEST(TermShares, ATermThatKnowsNoDesignHasNoShareInIt) {
  const Moving at(test::make_sideways_task(true, 8));
  const TermShares shares = at.objective.shares(at.s, at.m);
  EXPECT_EQ(shares.stationarity.size(), 0);
  for (std::size_t k = 0; k < shares.names.size(); ++k) {
    const double share = shares.partial_s.row(static_cast<Eigen::Index>(k)).norm();
    if (shares.names[k] == "style_com" || shares.names[k] == "force_balance") {
      EXPECT_EQ(share, 0.0) << shares.names[k];
    }
    if (shares.names[k] == "foot_position" || shares.names[k] == "torque_balance") {
      EXPECT_GT(share, 0.0) << shares.names[k];
    }
  }
}

TEST(Gradients, AreThoseOfTheFullOrders) {
  Task task = test::make_sideways_task(true, 8);
  task.weights["mechanical_work"] = 1.0;
  const Moving at(task);
  const Evaluation full = at.objective.evaluate(at.s, at.m, Order::design);
  const Evaluation first = at.objective.evaluate(at.s, at.m, Order::gradients);
  EXPECT_EQ(first.value, full.value);
  EXPECT_EQ(first.stationarity, full.stationarity);
  EXPECT_EQ(first.partial_s, full.partial_s);
  EXPECT_EQ(first.hessian_mm.size(), 0);
}

}  // namespace
}  // namespace legwright
