// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

TEST(IterationsLeft, IsTheLimitUntilThereIsATrend) {
  EXPECT_EQ(iterations_left({}, 1e-5, 60), 60);
  EXPECT_EQ(iterations_left({5.0, 4.0}, 1e-5, 58), 58);
  EXPECT_EQ(iterations_left({5.0, 4.0, 3.0, 2.5, 2.4}, 1e-5, 0), 0);
}

TEST(IterationsLeft, FollowsAGeometricDecrease) {
  // F = 1 + 2⁻ⁱ: the decrease over three iterations falls below 1e-5 at about i = 20.
  std::vector<double> history;
  for (int i = 0; i <= 8; ++i) history.push_back(1.0 + std::pow(0.5, i));
  EXPECT_NEAR(iterations_left(history, 1e-5, 60), 12, 2);
  history.assign(6, 1.0);
  EXPECT_EQ(iterations_left(history, 1e-5, 60), 1);
}

TEST(TimeLeft, IsSilentUntilThereIsATrend) {
  TimeLeft left(1e-5, 60);
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(left.after(i, 1.0 + std::pow(0.5, i), 1.0)) << i;
  EXPECT_TRUE(left.after(6, 1.0 + std::pow(0.5, 6), 1.0));
  EXPECT_FALSE(left.after(0, 2.0, 1.0)) << "another start has no trend yet";
}

TEST(TimeLeft, GuessesHowManyIterationsThereWillBe) {
  TimeLeft left(1e-5, 60);
  (void)left.after(0, 2.0, 1.0);
  EXPECT_EQ(left.iterations(), 60) << "no trend yet: the limit";
  for (int i = 1; i <= 8; ++i) (void)left.after(i, 1.0 + std::pow(0.5, i), 1.0);
  EXPECT_NEAR(left.iterations(), 20, 2);
}

TEST(TimeLeft, OneOddIterationDoesNotMoveIt) {
  // The same run with and without a hiccup: a slow iteration in which F hardly falls.
  const auto told = [](bool hiccup) {
    TimeLeft left(1e-5, 60);
    std::vector<double> seconds;
    for (int i = 0; i <= 12; ++i) {
      const bool odd = hiccup && i == 9;
      const auto guess = left.after(i, 1.0 + std::pow(0.5, odd ? i - 1 : i), odd ? 50.0 : 1.0);
      if (guess) seconds.push_back(*guess);
    }
    return seconds;
  };
  const auto calm = told(false), shaken = told(true);
  ASSERT_EQ(calm.size(), shaken.size());
  EXPECT_NEAR(calm.front(), 14.0, 3.0);
  for (std::size_t i = 0; i < calm.size(); ++i) {
    EXPECT_LT(shaken[i], 2.0 * calm[i]) << i;
    EXPECT_GT(shaken[i], 0.5 * calm[i]) << i;
  }
}

}  // namespace
}  // namespace legwright
