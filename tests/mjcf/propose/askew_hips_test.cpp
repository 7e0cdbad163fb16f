// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/askew_hips.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

namespace legwright {
namespace {

Eigen::Matrix2Xd places(const std::vector<double>& numbers) {
  return Eigen::Matrix2Xd::Map(numbers.data(), 2, static_cast<Eigen::Index>(numbers.size()) / 2);
}

/// Turned, and off the trunk's origin.
Eigen::Matrix2Xd drawn_askew(const Eigen::Matrix2Xd& given, double angle) {
  Eigen::Matrix2Xd out = Eigen::Rotation2Dd(angle).toRotationMatrix() * given;
  return out.colwise() + Eigen::Vector2d(0.03, -0.02);
}

/// So many around a circle, the first ahead.
Eigen::Matrix2Xd hips_around(int count) {
  Eigen::Matrix2Xd out(2, count);
  for (int k = 0; k < count; ++k)
    out.col(k) = 0.1 * Eigen::Rotation2Dd(2.0 * std::numbers::pi * k / count).toRotationMatrix() *
                 Eigen::Vector2d::UnitX();
  return out;
}

const Eigen::Matrix2Xd kOblong = places({.2, .1, .2, -.1, -.2, .1, -.2, -.1});
const Eigen::Matrix2Xd kTapered = places({.2, .06, .2, -.06, -.2, .1, -.2, -.1});

TEST(AskewHips, AreTurnedByAsMuchAsTheyAreDrawn) {
  for (const Eigen::Matrix2Xd& given : {kOblong, kTapered})
    for (const double angle : {0.1, -0.3, 0.7, 0.785}) {
      const auto found = askew_hips(drawn_askew(given, angle));
      ASSERT_TRUE(found.has_value()) << angle;
      EXPECT_NEAR(*found, angle, 1e-12);
    }
  EXPECT_NEAR(askew_hips(drawn_askew(kOblong, 0.1 + std::numbers::pi)).value_or(0.0), 0.1, 1e-12);
  EXPECT_NEAR(askew_hips(drawn_askew(kOblong, 0.1 - std::numbers::pi / 2.0)).value_or(0.0), 0.1,
              1e-12);
  EXPECT_NEAR(askew_hips(drawn_askew(hips_around(6), 0.1)).value_or(0.0), 0.1, 1e-12);
  EXPECT_NEAR(askew_hips(drawn_askew(hips_around(6), 0.45)).value_or(0.0),
              0.45 - std::numbers::pi / 6.0, 1e-12);
}

TEST(AskewHips, AreNoneWhereAnAxisMirrorsThem) {
  for (const Eigen::Matrix2Xd& given :
       {kOblong, kTapered, hips_around(4), hips_around(5), hips_around(6), hips_around(8)})
    for (const double angle : {0.0, 0.01, std::numbers::pi / 2.0, std::numbers::pi})
      EXPECT_FALSE(askew_hips(drawn_askew(given, angle)).has_value()) << angle;
  EXPECT_FALSE(askew_hips(drawn_askew(hips_around(4), std::numbers::pi / 4.0)).has_value());
}

TEST(AskewHips, AreNoneWhereNoPlaneMirrorsThem) {
  EXPECT_FALSE(askew_hips(drawn_askew(kOblong, 0.3).leftCols(2)).has_value()) << "a pair alone";
  Eigen::Matrix2Xd limp = drawn_askew(kOblong, 0.3);
  limp.col(1).x() += 0.02;
  EXPECT_FALSE(askew_hips(limp).has_value());
  Eigen::Matrix2Xd nearly = drawn_askew(kOblong, 0.3);
  nearly.col(1).x() += 0.001;
  EXPECT_NEAR(askew_hips(nearly).value_or(0.0), 0.3, 0.01);
}

}  // namespace
}  // namespace legwright
