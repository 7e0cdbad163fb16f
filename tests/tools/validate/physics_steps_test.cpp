// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/physics_steps.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

const VectorXd kLow = Vector2d(-5, -5), kHigh = Vector2d(5, 5), kStart = Vector2d(0, 0);

/// Curved, with its minimum at (2, −1).
PhysicsTrial valley(const VectorXd& x) {
  PhysicsTrial trial;
  trial.residual = Vector2d(x[0] - 2.0 + 0.1 * x[1] * (x[1] + 1.0), 2.0 * (x[1] + 1.0));
  trial.pass = true;
  return trial;
}

TEST(PhysicsSteps, FindTheMinimumOfASmoothGap) {
  const PhysicsStepsResult found = take_physics_steps(valley, kStart, kLow, kHigh, {.steps = 10});
  EXPECT_LT((found.x - Vector2d(2, -1)).norm(), 0.05);
  EXPECT_LT(found.best.merit(), 1e-3 * found.start.merit());
}

TEST(PhysicsSteps, NeverEndAboveTheirStart) {
  // Promises by its slope what it never holds: every step away from the start is worse.
  const auto liar = [](const VectorXd& x) {
    PhysicsTrial trial;
    const bool probe = std::abs(x.norm() - 0.5) < 1e-12;
    trial.residual = Vector2d(probe ? 0.5 : 1.0 + x.norm(), 1.0);
    return trial;
  };
  const PhysicsStepsResult found = take_physics_steps(liar, kStart, kLow, kHigh, {.steps = 10});
  EXPECT_EQ(found.x, kStart);
  ASSERT_FALSE(found.steps.empty());
  for (const PhysicsStep& step : found.steps) EXPECT_FALSE(step.accepted);
}

TEST(PhysicsSteps, GiveNoVerdictAwayForASmallerGap) {
  const auto fails_beyond_one = [](const VectorXd& x) {
    PhysicsTrial trial = valley(x);
    trial.pass = x[0] <= 1.0;
    return trial;
  };
  const PhysicsStepsResult found =
      take_physics_steps(fails_beyond_one, kStart, kLow, kHigh, {.steps = 20});
  EXPECT_TRUE(found.best.pass);
  EXPECT_LE(found.x[0], 1.0);
  EXPECT_LT(found.best.merit(), found.start.merit());
}

TEST(PhysicsSteps, StayWithinTheirBounds) {
  const VectorXd low = Vector2d(-0.25, -0.25), high = Vector2d(1.0, 0.5);
  const auto watched = [&](const VectorXd& x) {
    EXPECT_TRUE((x.array() >= low.array()).all() && (x.array() <= high.array()).all())
        << x.transpose();
    return valley(x);
  };
  const PhysicsStepsResult found = take_physics_steps(watched, kStart, low, high, {.steps = 10});
  EXPECT_DOUBLE_EQ(found.x[0], 1.0);
  EXPECT_DOUBLE_EQ(found.x[1], -0.25);
}

TEST(PhysicsSteps, PassOverGaitsThatDoNotExist) {
  const auto holes = [](const VectorXd& x) {
    if (x[1] != 0.0) return PhysicsTrial{};  // whatever changes the second scalar
    return valley(x);
  };
  const PhysicsStepsResult found = take_physics_steps(holes, kStart, kLow, kHigh, {.steps = 10});
  EXPECT_NEAR(found.x[0], 2.0, 0.05);
  EXPECT_EQ(found.x[1], 0.0);

  const auto nothing = [](const VectorXd&) { return PhysicsTrial{}; };
  EXPECT_TRUE(take_physics_steps(nothing, kStart, kLow, kHigh, {}).steps.empty());
  const auto no_number = [](const VectorXd&) {
    PhysicsTrial trial;
    trial.residual = Vector2d(std::numeric_limits<double>::quiet_NaN(), 0);
    return trial;
  };
  EXPECT_TRUE(take_physics_steps(no_number, kStart, kLow, kHigh, {}).steps.empty());
}

TEST(PhysicsSteps, AreTheSameOnAnyNumberOfThreads) {
  const PhysicsStepsResult one = take_physics_steps(valley, kStart, kLow, kHigh, {.threads = 1}),
                           four = take_physics_steps(valley, kStart, kLow, kHigh, {.threads = 4});
  EXPECT_EQ(one.x, four.x);
  EXPECT_EQ(one.trials, four.trials);
}

TEST(PhysicsSteps, HaveNothingToGainWhereThereIsNoGap) {
  const auto perfect = [](const VectorXd&) {
    PhysicsTrial trial;
    trial.residual = Vector2d(0, 0);
    return trial;
  };
  const PhysicsStepsResult found = take_physics_steps(perfect, kStart, kLow, kHigh, {});
  EXPECT_TRUE(found.steps.empty());
  EXPECT_EQ(found.x, kStart);
}

TEST(PhysicsSteps, StopWhenAsked) {
  std::atomic<int> plays = 0;
  const auto counted = [&](const VectorXd& x) {
    ++plays;
    return valley(x);
  };
  PhysicsStepOptions options;
  options.stop = [] { return true; };
  take_physics_steps(counted, kStart, kLow, kHigh, options);
  EXPECT_EQ(plays, 1);
}

}  // namespace
}  // namespace legwright
