// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/tightening.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "tests/tools/choose/problems.hpp"

namespace legwright {
namespace {

class TightenedTask : public testing::Test {
 protected:
  Task pull(Lever lever, const GaitTrial& seen = {}) const {
    return tightened_task(problem_, 0, Tightening{}.with(lever, seen));
  }
  const Task& asked() const { return problem_.objectives[0]->task(); }
  CodesignProblem problem_ = test::trot();
};

TEST_F(TightenedTask, IsTheTaskItselfWithoutAPull) {
  const Task same = tightened_task(problem_, 0, {});
  EXPECT_EQ(same.velocity, asked().velocity);
  EXPECT_EQ(same.planted_margin, asked().planted_margin);
  EXPECT_DOUBLE_EQ(*same.swing_height, *asked().swing_height);
  EXPECT_DOUBLE_EQ(same.torque_margin, asked().torque_margin);
  EXPECT_DOUBLE_EQ(same.friction, asked().friction);
  EXPECT_FALSE(Tightening{}.any());
  EXPECT_EQ(Tightening{}.words(), "");
}

TEST_F(TightenedTask, KeepsFartherFromEveryEdgeWithLargerMargins) {
  const Task task = pull(Lever::margins);
  EXPECT_GT(task.torque_margin, asked().torque_margin);
  EXPECT_LT(task.torque_margin, 1.0);
  EXPECT_GT(task.min_normal, asked().min_normal);
  EXPECT_LT(task.friction, asked().friction);
}

TEST_F(TightenedTask, MovesEachLeversOwnNumberAlone) {
  EXPECT_GT(pull(Lever::smooth_forces).weights.at("force_smoothness"), 0.05);
  EXPECT_LT(pull(Lever::quick_legs).weights.at("smoothness"), 0.3);
  EXPECT_GT(pull(Lever::smooth_legs).weights.at("smoothness"), 0.3);
  EXPECT_GT(pull(Lever::near_given_body).weights.at("design_tether"), 0.05);
  EXPECT_EQ(pull(Lever::long_stance).planted_margin, asked().planted_margin + 1);
  EXPECT_EQ(pull(Lever::short_stance).planted_margin, asked().planted_margin - 1);
  EXPECT_LT(*pull(Lever::low_swing).swing_height, *asked().swing_height);
  const Task low = pull(Lever::low_swing);
  EXPECT_EQ(low.velocity, asked().velocity);
  EXPECT_DOUBLE_EQ(low.friction, asked().friction);
}

TEST_F(TightenedTask, RefusesAStanceOfNoKnot) {
  Tightening tightening;
  for (int pull = 0; pull < asked().planted_margin; ++pull)
    tightening = tightening.with(Lever::short_stance, {});
  EXPECT_THROW(tightened_task(problem_, 0, tightening), InputError);
}

TEST_F(TightenedTask, NarrowsTheFootprintAcrossTheWayAlone) {
  const StyleTargets home =
      style_targets(problem_.robot.morphology, problem_.robot.space.initial(), asked());
  const Task narrow = pull(Lever::narrow), wide = pull(Lever::wide);
  for (std::size_t foot = 0; foot < home.footprint.size(); ++foot) {
    EXPECT_NEAR((*narrow.footprint)[foot].x(), home.footprint[foot].x(), 1e-12);
    EXPECT_LT(std::abs((*narrow.footprint)[foot].y()), std::abs(home.footprint[foot].y()));
    EXPECT_GT(std::abs((*wide.footprint)[foot].y()), std::abs(home.footprint[foot].y()));
  }
  EXPECT_EQ(narrow.follow_hips, !asked().footprint);  // the lever decides width, not whose it is
}

TEST_F(TightenedTask, AimsForWhatMujocoLoses) {
  GaitTrial seen;
  seen.speed_ratio = 0.9;
  seen.heading_drift = 0.02;  // rad a cycle to the left
  const Task task = pull(Lever::aim, seen);
  EXPECT_NEAR(task.velocity.x(), 0.4 / 0.9, 1e-12);
  EXPECT_NEAR(task.turn_rate, -0.02 / 0.4, 1e-12);
  // Twice: what was corrected already counts.
  const Tightening twice = Tightening{}.with(Lever::aim, seen).with(Lever::aim, seen);
  EXPECT_NEAR(tightened_task(problem_, 0, twice).turn_rate, -0.04 / 0.4, 1e-12);
  EXPECT_EQ(twice.words(), "corrected aim x2");
}

TEST_F(TightenedTask, AimsAtATurnThatIsLostOnce) {
  const CodesignProblem turning =
      test::problem_of("quadruped",
                       "[gait]\nname = \"trot\"\nperiod = 0.4\n[travel]\nvelocity = [0.2, 0.0]\n"
                       "turn_rate = 0.5\naim_speed = 1.1\naim_turn_rate = 0.1\n");
  GaitTrial seen;
  seen.speed_ratio = 0.9;
  seen.heading_drift = -0.02;  // rad a cycle
  const Task task = tightened_task(turning, 0, Tightening{}.with(Lever::aim, seen));
  EXPECT_NEAR(task.velocity.x(), 1.1 * 0.2 / 0.9, 1e-12);
  EXPECT_NEAR(task.turn_rate, 1.1 * 0.5 + 0.1 + 0.02 / 0.4, 1e-12);
}

TEST_F(TightenedTask, AimsAtTheSpeedAloneOnASlope) {
  const CodesignProblem slope =
      test::problem_of("quadruped",
                       "[gait]\nname = \"trot\"\nperiod = 0.4\n[travel]\nvelocity = [0.2, 0.0]\n"
                       "[ground]\nslope_along = 0.1\n");
  GaitTrial seen;
  seen.speed_ratio = 0.9;
  seen.heading_drift = 0.02;
  const Task task = tightened_task(slope, 0, Tightening{}.with(Lever::aim, seen));
  EXPECT_NEAR(task.velocity.head<2>().norm(), 0.2 / 0.9, 1e-12);
  EXPECT_EQ(task.turn_rate, 0.0);
}

}  // namespace
}  // namespace legwright
