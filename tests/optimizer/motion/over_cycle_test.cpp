// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/over_cycle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace legwright {
namespace {

TEST(OverCycle, MeetsTheValuesAtTheirTimesAndIsStraightBetween) {
  const std::vector<double> values{1.0, 3.0, 2.0};
  for (int k = 0; k < 3; ++k) EXPECT_EQ(over_cycle(values, k / 3.0), values[k]);
  EXPECT_NEAR(over_cycle(values, 0.5 / 3), 2.0, 1e-12);
  EXPECT_NEAR(over_cycle(values, 1.75 / 3), 2.25, 1e-12);
  EXPECT_NEAR(over_cycle(values, 2.5 / 3), 1.5, 1e-12) << "from the last back to the first";
}

TEST(OverCycle, RepeatsEachCycle) {
  const std::vector<double> values{1.0, 3.0, 2.0, 7.0};
  for (double phase : {0.0, 0.1, 0.25, 0.8}) {
    EXPECT_NEAR(over_cycle(values, phase + 1.0), over_cycle(values, phase), 1e-12);
    EXPECT_NEAR(over_cycle(values, phase - 2.0), over_cycle(values, phase), 1e-12);
  }
  EXPECT_EQ(over_cycle(values, 1.0), 1.0);
}

TEST(OverCycle, OneValuePerKnotIsThatValueWhateverTheRounding) {
  for (int knots : {8, 10, 24, 49, 384}) {
    std::vector<double> values;
    for (int k = 0; k < knots; ++k) values.push_back(k % 7 + 0.25 * k);
    for (int k = 0; k < knots; ++k)
      EXPECT_EQ(over_cycle(values, static_cast<double>(k) / knots), values[k]) << k << "/" << knots;
  }
}

TEST(OverCycle, TakesOneValueAndVectors) {
  EXPECT_EQ(over_cycle(std::vector<double>{5.0}, 0.7), 5.0);
  const std::vector<Eigen::Vector2d> places{{0.0, 1.0}, {2.0, -1.0}};
  EXPECT_LT((over_cycle(places, 0.25) - Eigen::Vector2d(1.0, 0.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace legwright
