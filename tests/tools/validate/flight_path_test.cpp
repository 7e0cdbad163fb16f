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

TEST(FlightPath, AHighLiftBeforeTheMiddleDoesNotCount) {
  const auto early = [](double share) { return 0.04 * std::sin(M_PI * std::pow(share, 0.3)); };
  EXPECT_LT(flight(0.1, early).clearance(), 0.03);
  EXPECT_GT(flight(0.0, early).clearance(), 0.039);  // it comes down where it left
}

TEST(FlightPath, GoingBackOverTheMiddleTakesTheLowestCrossing) {
  FlightPath path;
  for (const auto& [x, z] : {std::pair{0.0, 0.0}, {0.06, 0.05}, {0.04, 0.02}, {0.06, 0.03}})
    path.add({x, 0.0, z});
  path.add({0.1, 0.0, 0.0});
  EXPECT_NEAR(path.clearance(), 0.025, 1e-12);  // 0.025 forward again, 0.035 back, 0.0417 first
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
