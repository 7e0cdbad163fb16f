// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/progress.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace legwright
