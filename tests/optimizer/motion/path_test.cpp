// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector2d kVelocity(0.08, -0.03);

TEST(WantedPath, IsTheIntegralOfAConstantVelocityInATurningFrame) {
  for (double rate : {0.0, 1e-7, 0.3, -2.0}) {
    const WantedPath path(kVelocity, rate, 1.0);
    Vector2d place = Vector2d::Zero();
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const Eigen::Matrix3d turn = WantedPath::yaw_rotation(rate * (i + 0.5) / kSteps);
      place += turn.topLeftCorner<2, 2>() * kVelocity / kSteps;
    }
    EXPECT_LT((path.travel().head<2>() - place).norm(), 1e-9) << rate;
    EXPECT_EQ(path.travel().z(), 0.0);
  }
}

TEST(WantedPath, GoesOnAfterACycleByTheCyclesRigidMotion) {
  const WantedPath path(kVelocity, 0.7, 0.8);
  for (double time : {0.0, 0.3, 0.8}) {
    const Vector3d later = path.turn() * path.position(time) + path.travel();
    EXPECT_LT((path.position(time + 0.8) - later).norm(), 1e-15);
    EXPECT_NEAR(path.heading(time + 0.8), path.heading(time) + path.turn_angle(), 1e-15);
  }
}

TEST(VelocityAlongArc, IsTheInverseOfThePath) {
  for (double rate : {0.0, 1e-7, 1e-5, 0.3, -2.0, 5.0}) {
    const double time = 0.9;
    const Vector2d step = WantedPath(kVelocity, rate, time).position(time).head<2>();
    const Vector2d velocity = WantedPath::velocity_along_arc(step, rate * time, time);
    EXPECT_LT((velocity - kVelocity).norm(), 1e-12) << rate;
  }
}

TEST(VelocityAlongArc, IsLongerThanTheChord) {
  const double quarter = std::acos(-1.0) / 2;  // of a circle of radius one, in one second
  const Vector2d step(1.0, 1.0);
  const Vector2d velocity = WantedPath::velocity_along_arc(step, quarter, 1.0);
  EXPECT_NEAR(velocity.x(), quarter, 1e-12);
  EXPECT_NEAR(velocity.y(), 0.0, 1e-12);
  EXPECT_GT(velocity.norm(), step.norm() + 0.1);
}

TEST(VelocityAlongArc, KnowsNothingOfAFullCircle) {
  const double circle = 2 * std::acos(-1.0);
  EXPECT_TRUE(std::isnan(WantedPath::velocity_along_arc(Vector2d::Zero(), circle, 1.0).x()));
}

}  // namespace
}  // namespace legwright
