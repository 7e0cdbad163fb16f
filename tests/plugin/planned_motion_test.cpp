// SPDX-License-Identifier: Apache-2.0
#include "plugin/planned_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plugin/clock.hpp"
#include "tests/plugin/toy_trajectory.hpp"

namespace legwright {
namespace {

Trajectory plan(double turn) {
  Trajectory t = toy_trajectory(2, 2, 10, 0.7, 3, 0.4);
  t.travel = {0.3, -0.1, 0.02};
  t.turn = turn;
  return t;
}

void expect_near(const Point& a, const Point& b, double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

/// The rigid motion of one cycle, about the root at knot 0.
Point cycle_on(const Trajectory& t, const Point& p) {
  const double x = t.at(0, t.root_column(0)), y = t.at(0, t.root_column(1));
  const double c = std::cos(t.turn), s = std::sin(t.turn);
  return {x + c * (p[0] - x) - s * (p[1] - y) + t.travel[0],
          y + s * (p[0] - x) + c * (p[1] - y) + t.travel[1], p[2] + t.travel[2]};
}

TEST(PlannedMotion, WithoutTurnIsTheSampledTrajectory) {
  const Trajectory t = plan(0.0);
  const PlannedMotion motion(t);
  TrajectorySample expected;
  for (const double time : {-3.1, 0.0, 0.05, 0.34, 0.69, 12.3}) {
    const SplinePhase phase = phase_at(t, time);
    sample(t, time, expected);
    expect_near(motion.com(phase), expected.com, 1e-12);
    const Pose root = motion.root(phase);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(root.position[axis], expected.root[axis], 1e-12);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const int number = static_cast<int>(foot);
      expect_near(motion.foot(phase, number), expected.foot[foot], 1e-12);
      expect_near(motion.force(phase, number), expected.force[foot], 1e-12);
      EXPECT_EQ(motion.contact(phase, number), expected.contact[foot]);
    }
  }
}

TEST(PlannedMotion, OneCycleOnIsTheRigidMotionOfTheGround) {
  for (const double turn : {0.4, -1.3, std::numbers::pi, 1e-13, 2 * std::numbers::pi}) {
    const Trajectory t = plan(turn);
    const PlannedMotion motion(t);
    for (const double time : {-2.0, 0.01, 0.3, 0.66}) {
      const SplinePhase now = phase_at(t, time), later = phase_at(t, time + t.period);
      expect_near(motion.foot(later, 1), cycle_on(t, motion.foot(now, 1)), 1e-11);
      expect_near(motion.com(later), cycle_on(t, motion.com(now)), 1e-11);
      const Pose a = motion.root(now), b = motion.root(later);
      expect_near(b.position, cycle_on(t, a.position), 1e-11);
      // The heading turned on by `turn`: Rz(turn)·q, up to the sign of a quaternion.
      const double c = std::cos(turn / 2), s = std::sin(turn / 2);
      const auto& q = a.quaternion;
      const double same =
          b.quaternion[0] * (c * q[0] - s * q[3]) + b.quaternion[1] * (c * q[1] - s * q[2]) +
          b.quaternion[2] * (c * q[2] + s * q[1]) + b.quaternion[3] * (c * q[3] + s * q[0]);
      EXPECT_NEAR(std::abs(same), 1.0, 1e-12);
      const Point f = motion.force(now, 0), g = motion.force(later, 0);
      EXPECT_NEAR(g[0], std::cos(turn) * f[0] - std::sin(turn) * f[1], 1e-11);
      EXPECT_NEAR(g[2], f[2], 1e-11);
    }
  }
}

TEST(PlannedMotion, RatesAreDerivatives) {
  constexpr double kStep = 1e-6;
  for (const double turn : {0.0, 0.4}) {
    const Trajectory t = plan(turn);
    const PlannedMotion motion(t);
    for (const double time : {-2.05, 0.011, 3.17}) {
      const auto at = [&](double when) {
        return motion.point(phase_at(t, when), t.foot_column(1, 0));
      };
      const MovingPoint before = at(time - kStep), now = at(time), after = at(time + kStep);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(now.rate[axis], (after.value[axis] - before.value[axis]) / (2 * kStep), 1e-6);
        EXPECT_NEAR(now.acceleration[axis], (after.rate[axis] - before.rate[axis]) / (2 * kStep),
                    1e-4);
      }
    }
  }
}

TEST(PlannedMotion, CircleCloses) {
  Trajectory t = plan(2 * std::numbers::pi / 12);
  t.travel[2] = 0.0;
  const PlannedMotion motion(t);
  expect_near(motion.com(phase_at(t, 0.2 + 12 * t.period)), motion.com(phase_at(t, 0.2)), 1e-10);
  EXPECT_GT(
      std::abs(motion.com(phase_at(t, 0.2 + 6 * t.period))[1] - motion.com(phase_at(t, 0.2))[1]),
      0.1);  // it was elsewhere meanwhile
}

TEST(Clock, BlendIsSmoothAndItsRateIsItsDerivative) {
  Clock clock;
  EXPECT_EQ(blend_at(clock, -1.0).share, 1.0);  // without blend_in, the gait always
  clock.blend_in = 0.8;
  EXPECT_EQ(blend_at(clock, -1.0).share, 0.0);
  EXPECT_EQ(blend_at(clock, 0.0).share, 0.0);
  EXPECT_EQ(blend_at(clock, 0.8).share, 1.0);
  EXPECT_EQ(blend_at(clock, 0.8).rate, 0.0);
  constexpr double kStep = 1e-5;
  double before = 0.0;
  for (int i = -10; i <= 90; ++i) {
    const double time = 0.01 * i;
    const Blend blend = blend_at(clock, time);
    const double slope =
        (blend_at(clock, time + kStep).share - blend_at(clock, time - kStep).share) / (2 * kStep);
    EXPECT_NEAR(blend.rate, slope, 1e-7) << time;
    EXPECT_GE(blend.share, before);
    before = blend.share;
  }
  clock.t0 = 0.1;
  clock.speed = -2.0;
  EXPECT_EQ(clock.plan_time(0.4), 0.1 - 2.0 * 0.4);
}

}  // namespace
}  // namespace legwright
