// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/path_deviation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer/motion/path.hpp"

namespace legwright {
namespace {

const Eigen::Vector2d kAhead(0.1, 0.0), kLeft(0.0, 0.1);

TEST(PathDeviation, OfAStraightWayIsWhatLiesAcrossIt) {
  EXPECT_EQ(distance_from_path({}, kAhead, 0.0), 0.0);
  EXPECT_NEAR(distance_from_path({{1.0, 2.0}, {2.0, 2.3}, {9.0, 1.9}}, kAhead, 0.0), 0.3, 1e-12);
  EXPECT_NEAR(distance_from_path({{0.0, 0.0}, {0.2, 5.0}}, kLeft, 0.0), 0.2, 1e-12);
  // Set off at a heading of a quarter turn, its forward is the world's +y.
  EXPECT_NEAR(distance_from_path({{0.0, 0.0}, {0.2, 5.0}}, kAhead, 0.0, M_PI / 2), 0.2, 1e-12);
}

TEST(PathDeviation, OfAnArcIsTheDistanceFromItsCircle) {
  for (const Eigen::Vector2d& velocity : {kAhead, kLeft, Eigen::Vector2d(-0.05, 0.02)})
    for (const double rate : {0.3, -0.3}) {
      const WantedPath path(velocity, rate, 1.0);
      std::vector<Eigen::Vector2d> on_it;
      for (int k = 0; k < 30; ++k) on_it.emplace_back(path.position(0.9 * k).head<2>());
      EXPECT_NEAR(distance_from_path(on_it, velocity, rate), 0.0, 1e-9);
      // One that went ahead of its time on the same circle is on its way; one inside is not.
      const Eigen::Vector2d centre =
          Eigen::Vector2d(-velocity.y(), velocity.x()) / rate;  // of the circle
      std::vector<Eigen::Vector2d> inside{on_it.front(), centre + 0.8 * (on_it[7] - centre)};
      EXPECT_NEAR(distance_from_path(inside, velocity, rate), 0.2 * centre.norm(), 1e-9);
    }
}

TEST(PathDeviation, OfAVeryWideArcIsThatOfAStraightWay) {
  const std::vector<Eigen::Vector2d> points{{0.0, 0.0}, {1.0, 0.07}, {2.0, -0.2}};
  EXPECT_NEAR(distance_from_path(points, kAhead, 1e-12), distance_from_path(points, kAhead, 0.0),
              1e-9);
}

}  // namespace
}  // namespace legwright
