// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/convex_distance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace legwright {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> cube(double half, const Eigen::Isometry3d& pose) {
  std::vector<Vector3d> out;
  for (const double x : {-half, half})
    for (const double y : {-half, half})
      for (const double z : {-half, half}) out.emplace_back(pose * Vector3d(x, y, z));
  return out;
}

Eigen::Isometry3d turned(const Vector3d& place, double angle, const Vector3d& axis) {
  Eigen::Isometry3d out(Eigen::AngleAxisd(angle, axis.normalized()));
  out.translation() = place;
  return out;
}

TEST(ConvexDistance, BetweenFacesEdgesAndCorners) {
  const std::vector<Vector3d> still = cube(0.01, Eigen::Isometry3d::Identity());
  const auto to = [&](const Eigen::Isometry3d& pose) {
    return convex_distance(still, cube(0.01, pose));
  };
  EXPECT_NEAR(to(turned({0.05, 0.003, 0.001}, 0.0, Vector3d::UnitX())), 0.03, 1e-12);
  const double diagonal = 0.01 * std::sqrt(2.0);
  EXPECT_NEAR(to(turned({0.05, 0.0, 0.0}, std::acos(-1.0) / 4.0, Vector3d::UnitZ())),
              0.04 - diagonal, 1e-12);
  EXPECT_NEAR(to(turned({0.05, 0.05, 0.05}, 0.0, Vector3d::UnitX())), 0.03 * std::sqrt(3.0), 1e-12);
  EXPECT_EQ(to(turned({0.015, 0.003, 0.001}, 0.4, {1, 2, 3})), 0.0);
}

// Along the way that the result would give, the shapes are apart; and no two of their points are
// nearer.
TEST(ConvexDistance, IsNoMoreThanThatOfAnyTwoPoints) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto some = [&] {
    const double x = number(random), y = number(random), z = number(random);
    return Vector3d(x, y, z);
  };
  for (int round = 0; round < 100; ++round) {
    const std::vector<Vector3d> a = cube(1.0, turned(some(), some().x(), some())),
                                b = cube(0.5, turned(3.0 * some(), some().x(), some()));
    const double distance = convex_distance(a, b);
    EXPECT_NEAR(distance, convex_distance(b, a), 1e-9);
    for (int k = 0; k < 100; ++k) {
      Vector3d p = Vector3d::Zero(), q = p;
      double of_p = 0.0, of_q = 0.0;
      for (std::size_t c = 0; c < 8; ++c) {
        const double u = std::pow(std::abs(number(random)), 4),
                     v = std::pow(std::abs(number(random)), 4);
        p += u * a[c];
        of_p += u;
        q += v * b[c];
        of_q += v;
      }
      EXPECT_GE((p / of_p - q / of_q).norm(), distance - 1e-9);
    }
  }
}

}  // namespace
}  // namespace legwright
