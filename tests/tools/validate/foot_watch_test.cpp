// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/foot_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace legwright {
namespace {

constexpr double kStep = 0.001, kPeriod = 1.0;

// One foot that stands from knot 0 to knot 4 of 8, that is from 0 to 0.5 s of each second.
Trajectory plan() {
  Trajectory out = blank_trajectory({"a"}, {"F"}, 8, kPeriod);
  for (int knot = 0; knot <= 4; ++knot) out.at(knot, out.contact_column(0)) = 1;
  return out;
}

// Five cycles in which the foot stands in [from, to) of each, slipping at 0.01 m/s.
FootMeasures watch(double from, double to, const Trajectory& trajectory = plan()) {
  FootWatch foot(trajectory, 0, 2.0);
  for (int n = 0; n <= 5000; ++n) {
    const double time = n * kStep, phase = std::fmod(time + kStep / 2, kPeriod);
    const bool down = from < 0 ? phase < to || phase >= 1 + from : phase >= from && phase < to;
    foot.observe(time, kStep, {.in_contact = down, .slip_speed = 0.01});
  }
  return foot.finish(5.0);
}

// Five cycles; in each the foot stands for half a second, then steps 0.1 m ahead over `height`. It
// chatters when it lands: for a few steps it is off again.
FootMeasures stepping(double height, double lift_of_third = 1.0) {
  FootWatch foot(plan(), 0, 2.0);
  for (int n = 0; n <= 5000; ++n) {
    const double time = n * kStep, phase = std::fmod(time + kStep / 2, kPeriod);
    const int cycle = static_cast<int>(time + kStep / 2);
    const double share = std::max(0.0, phase - 0.5) / 0.5;
    const bool chatter = phase > 0.02 && phase < 0.03 && cycle > 0;
    const double lift = height * (cycle == 2 ? lift_of_third : 1.0);
    foot.observe(time, kStep,
                 {.in_contact = phase < 0.5 && !chatter,
                  .sole = {0.1 * (cycle + share), 0.0, lift * std::sin(M_PI * share)}});
  }
  return foot.finish(5.0);
}

TEST(FootWatch, AStepPassesOverWhatIsLowerThanItsMiddle) {
  const FootMeasures foot = stepping(0.03);
  EXPECT_EQ(foot.swings, 3);
  EXPECT_NEAR(foot.clearance_min, 0.03, 1e-4);
  EXPECT_NEAR(foot.clearance_mean, 0.03, 1e-4);
}

TEST(FootWatch, TheLowestStepCounts) {
  const FootMeasures foot = stepping(0.03, 0.5);
  EXPECT_NEAR(foot.clearance_min, 0.015, 1e-4);
  EXPECT_NEAR(foot.clearance_mean, 0.025, 1e-4);
}

TEST(FootWatch, AFootThatNeverLiftsPassesOverNothing) {
  const FootMeasures foot = watch(-0.6, 1.0);
  EXPECT_GT(foot.swings, 0);
  EXPECT_EQ(foot.clearance_min, 0.0);
}

TEST(FootWatch, LateTouchdownIsPositive) {
  const FootMeasures foot = watch(0.03, 0.5);
  EXPECT_EQ(
      foot.stances,
      3);  // strides begin at 0.75 s; that of the first cycle and the open last one do not count
  EXPECT_NEAR(foot.touchdown_mean, 0.03, 2 * kStep);
  EXPECT_NEAR(foot.touchdown_max, 0.03, 2 * kStep);
  EXPECT_EQ(foot.missed, 0);
}

TEST(FootWatch, EarlyTouchdownIsNegative) {
  const FootMeasures foot = watch(-0.02, 0.5);
  EXPECT_NEAR(foot.touchdown_mean, -0.02, 2 * kStep);
  EXPECT_NEAR(foot.touchdown_max, 0.02, 2 * kStep);
}

TEST(FootWatch, LiftOffIsTheEndOfTheLastContact) {
  const FootMeasures late = watch(0.0, 0.54), early = watch(0.0, 0.47);
  EXPECT_NEAR(late.liftoff_mean, 0.04, 2 * kStep);  // the last knot with force is at 0.5 s
  EXPECT_NEAR(late.liftoff_max, 0.04, 2 * kStep);
  EXPECT_NEAR(early.liftoff_mean, -0.03, 2 * kStep);
  EXPECT_NEAR(early.liftoff_max, 0.03, 2 * kStep);
  EXPECT_NEAR(early.touchdown_mean, 0.0, 2 * kStep);
}

TEST(FootWatch, LandingSpeedIsThatOfTheMomentBeforeAndRollIsWithoutTheAir) {
  FootWatch foot(plan(), 0, 2.0);
  for (int n = 0; n <= 5000; ++n) {
    const double phase = std::fmod(n * kStep + kStep / 2, kPeriod);
    const bool down = phase < 0.5;
    // Rolls ahead by 0.4 rad/s, but back again for a fifth of the stance; tumbles in the air.
    const double roll = !down ? 7.0 : phase < 0.4 ? 0.4 : -0.4;
    foot.observe(n * kStep, kStep,
                 {.in_contact = down, .sink_speed = down ? -5.0 : 0.2, .roll_rate = {0.0, roll}});
  }
  const FootMeasures out = foot.finish(5.0);
  EXPECT_NEAR(out.landing_mean, 0.2, 1e-12);
  EXPECT_NEAR(out.landing_max, 0.2, 1e-12);
  EXPECT_NEAR(out.roll_mean, 0.4 * 0.4 - 0.4 * 0.1, 2e-3);
}

TEST(FootWatch, SlipIsPathPerStance) {
  const FootMeasures foot = watch(0.0, 0.5);
  EXPECT_NEAR(foot.slip_mean, 0.005, 1e-4);
  EXPECT_NEAR(foot.slip_max, 0.005, 1e-4);
}

TEST(FootWatch, FootThatNeverLandsMissesItsStances) {
  const FootMeasures foot = watch(2.0, 3.0);
  EXPECT_EQ(foot.missed, 3);
  EXPECT_EQ(foot.slip_max, 0.0);
}

TEST(FootWatch, FootThatNeverLiftsTouchedDownInMidSwing) {
  const FootMeasures foot = watch(0.0, 2.0);
  EXPECT_EQ(foot.missed, 0);
  EXPECT_NEAR(foot.touchdown_mean, -0.25, 2 * kStep);
}

TEST(FootWatch, RecordsPlannedAndMeasuredContactsUpToItsLimit) {
  const FootMeasures foot = watch(0.1, 0.5);
  ASSERT_EQ(foot.planned.size(), 1U);
  EXPECT_DOUBLE_EQ(foot.planned[0].first, 0.0);
  EXPECT_DOUBLE_EQ(foot.planned[0].second, 0.5);
  ASSERT_EQ(foot.contacts.size(), 2U);
  EXPECT_NEAR(foot.contacts[1].first, 1.1, 2 * kStep);
  EXPECT_NEAR(foot.contacts[1].second, 1.5, 2 * kStep);
}

TEST(FootWatch, StanceAcrossTheEndOfTheCycleIsOne) {
  Trajectory wrapped = blank_trajectory({"a"}, {"F"}, 8, kPeriod);
  for (const int knot : {6, 7, 0, 1}) wrapped.at(knot, wrapped.contact_column(0)) = 1;
  const FootMeasures foot = watch(-0.23, 0.13, wrapped);
  ASSERT_EQ(foot.planned.size(), 1U);
  EXPECT_DOUBLE_EQ(foot.planned[0].first, 0.75);
  EXPECT_DOUBLE_EQ(foot.planned[0].second, 1.125);
  EXPECT_NEAR(foot.touchdown_mean, 0.02, 2 * kStep);
}

}  // namespace
}  // namespace legwright
