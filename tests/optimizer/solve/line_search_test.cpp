// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/line_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/not_finite.hpp"

namespace legwright {
namespace {

using test::kNan;

TEST(LineSearch, TakesTheFullStepWhereItGoesDown) {
  const auto phi = [](double t) { return (t - 1.0) * (t - 1.0); };
  const LineSearchResult found = backtrack(1.0, -2.0, 1.0, phi);
  EXPECT_TRUE(found.success);
  EXPECT_EQ(found.step, 1.0);
  EXPECT_EQ(found.trials, 1);
}

TEST(LineSearch, FindsTheMinimumOfAParabolaInTwoTrials) {
  const auto phi = [](double t) { return 9.0 * t * t - 6.0 * t; };  // minimum at 1/3
  const LineSearchResult found = backtrack(0.0, -6.0, 1.0, phi);
  ASSERT_TRUE(found.success);
  EXPECT_NEAR(found.step, 1.0 / 3.0, 1e-15);
  EXPECT_EQ(found.trials, 2);
  EXPECT_EQ(found.value, phi(found.step));
}

TEST(LineSearch, StepsBackFromWhatIsNotFinite) {
  for (const double poison :
       {kNan, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    const auto phi = [poison](double t) { return t > 0.2 ? poison : -t; };
    const LineSearchResult found = backtrack(0.0, -1.0, 1.0, phi);
    ASSERT_TRUE(found.success);
    EXPECT_LE(found.step, 0.2);
    EXPECT_TRUE(std::isfinite(found.value));
  }
}

TEST(LineSearch, GivesUpWhereNothingHelps) {
  int calls = 0;
  const auto uphill = [&calls](double t) {
    return ++calls, t;
  };  // the slope that is claimed is a lie
  const LineSearchResult found = backtrack(0.0, -1.0, 1.0, uphill, {.max_trials = 7});
  EXPECT_FALSE(found.success);
  EXPECT_EQ(found.step, 0.0);
  EXPECT_EQ(found.value, 0.0);
  EXPECT_EQ(calls, 7);
}

TEST(LineSearch, DoesNotTryADirectionThatGoesUp) {
  int calls = 0;
  const auto phi = [&calls](double t) { return ++calls, -t; };
  EXPECT_FALSE(backtrack(0.0, 1.0, 1.0, phi).success);
  EXPECT_FALSE(backtrack(0.0, 0.0, 1.0, phi).success);
  EXPECT_FALSE(backtrack(0.0, kNan, 1.0, phi).success);
  EXPECT_FALSE(backtrack(kNan, -1.0, 1.0, phi).success);
  EXPECT_EQ(calls, 0);
}

TEST(LineSearch, ATinyDecreaseIsNotSufficient) {
  const auto phi = [](double t) { return -1e-6 * t; };
  EXPECT_FALSE(backtrack(0.0, -1.0, 1.0, phi).success);
  EXPECT_TRUE(backtrack(0.0, -1.0, 1.0, phi, {.sufficient_decrease = 1e-7}).success);
}

TEST(LineSearch, StandingStillIsNoSuccess) {
  const auto flat = [](double) { return 1.0; };  // the promise, 1e-30, is below rounding
  EXPECT_FALSE(backtrack(1.0, -1e-26, 1.0, flat).success);
}

}  // namespace
}  // namespace legwright
