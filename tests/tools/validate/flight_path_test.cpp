// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/flight_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace legwright {
namespace {

/// From x = 0 to `length`, as high as `height` says by the share of the way.
template <typename Height>
FlightPath flight(double length, const Height& height, int parts = 101) {
  FlightPath path;
  for (int k = 0; k < parts; ++k) {
    const double share = static_cast<double>(k) / (parts - 1);
    path.add({0.3, 1.0 + length * share, height(share)});
  }
  return path;
}

double arc(double share) { return 0.04 * std::sin(M_PI * share); }

TEST(FlightPath, OfAnArcIsItsHeightInTheMiddle) {
  EXPECT_NEAR(flight(0.1, arc).clearance(), 0.04, 1e-4);
  EXPECT_NEAR(flight(-0.1, arc, 6).clearance(), 0.04 * std::sin(0.4 * M_PI), 1e-6);  // in between
}

TEST(FlightPath, ALiftOutsideOfTheMiddleHalfDoesNotCount) {
  const auto early = [](double share) { return 0.04 * std::sin(M_PI * std::pow(share, 0.15)); };
  const double at_quarter = early(0.25);
  ASSERT_LT(at_quarter, 0.024);  // its top is at a hundredth of the way
  EXPECT_NEAR(flight(0.1, early).clearance(), at_quarter, 1e-4);
  EXPECT_GT(flight(0.0, early).clearance(), 0.039);  // it comes down where it left
}

TEST(FlightPath, ABarIsPassedAsHighAsTheLowestCrossing) {
  FlightPath path;
  for (const auto& [x, z] : {std::pair{0.0, 0.0}, {0.08, 0.05}, {0.02, 0.02}, {0.08, 0.03}})
    path.add({x, 0.0, z});
  path.add({0.1, 0.0, 0.0});
  // First at 0.05/0.08 x, then back, then forward again from 20 to 30 mm: lowest at the last but
  // near the start.
  EXPECT_NEAR(path.clearance(), 0.02 + 0.01 * (0.075 - 0.02) / 0.06, 1e-9);
}

TEST(FlightPath, AFootThatRushesAheadStillPassesOverABarWhereItIsHigh) {
  FlightPath path;
  for (const auto& [x, z] :
       {std::pair{0.0, 0.0}, {0.06, 0.02}, {0.10, 0.05}, {0.12, 0.05}, {0.10, 0.0}})
    path.add({x, 0.0, z});
  EXPECT_NEAR(path.clearance(), 0.02 + 0.03 * 0.015 / 0.04, 1e-9);  // at three quarters of 0.1 m
}

TEST(FlightPath, OfNothingIsNothing) {
  FlightPath path;
  EXPECT_EQ(path.clearance(), 0.0);
  path.add({0.0, 0.0, 0.3});
  path.clear();
  EXPECT_EQ(path.size(), 0U);
}

}  // namespace
}  // namespace legwright
