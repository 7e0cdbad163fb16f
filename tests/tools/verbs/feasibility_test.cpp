// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/feasibility.hpp"

#include <gtest/gtest.h>

#include "tools/verbs/judge_run.hpp"

namespace legwright {
namespace {

PlanQuality good() {
  PlanQuality quality;
  quality.speed_wanted = 0.1;
  quality.speed_reached = 0.0999;
  quality.heading_error = 0.05;
  quality.root_residual = 0.02;
  return quality;
}

TEST(Feasibility, AcceptsAPlanThatDoesItsTask) {
  EXPECT_TRUE(infeasible_reasons(true, good(), "m/s").empty());
}

TEST(Feasibility, NamesWhatIsMissed) {
  PlanQuality slow = good();
  slow.speed_reached = 0.02;
  ASSERT_EQ(infeasible_reasons(true, slow, "m/s").size(), 1u);
  EXPECT_EQ(infeasible_reasons(true, slow, "m/s")[0], "the plan reaches 0.02 of 0.1 m/s (20 %)");
  PlanQuality turned = good();
  turned.heading_error = 1.4;
  EXPECT_NE(infeasible_reasons(true, turned, "m/s").at(0).find("1.40 rad"), std::string::npos);
  PlanQuality straight = good();  // on, but hardly round
  straight.turn_wanted = 0.1;
  straight.turn_reached = 0.05;
  ASSERT_EQ(infeasible_reasons(true, straight, "m/s").size(), 1u);
  EXPECT_EQ(infeasible_reasons(true, straight, "m/s")[0],
            "the plan turns at 0.05 of 0.1 rad/s (50 %)");
  straight.turn_reached = 0.099;
  EXPECT_TRUE(infeasible_reasons(true, straight, "m/s").empty());
  PlanQuality spot = straight;  // on the spot a turn missed is told once
  spot.speed_reached = spot.turn_reached = 0.02;
  EXPECT_EQ(infeasible_reasons(true, spot, "rad/s").size(), 1u);
  PlanQuality floating = good();
  floating.ground_error = 0.02;
  EXPECT_NE(infeasible_reasons(true, floating, "m/s").at(0).find("20.0 mm"), std::string::npos);
  PlanQuality sliding = good();
  sliding.slide_share = 0.97;
  EXPECT_NE(infeasible_reasons(true, sliding, "m/s").at(0).find("97 %"), std::string::npos);
  PlanQuality pushed = good();
  pushed.root_residual = 0.8;
  EXPECT_NE(infeasible_reasons(true, pushed, "m/s").at(0).find("80 %"), std::string::npos);
  EXPECT_EQ(infeasible_reasons(false, good(), "m/s").size(), 1u);
}

/// A share of nearly nothing is none that counts.
TEST(Feasibility, WhatIsMissedByNothingThatCountsIsNot) {
  PlanQuality straight = good();
  straight.turn_wanted = 0.00052;
  straight.turn_reached = 0.00046;
  EXPECT_TRUE(infeasible_reasons(true, straight, "m/s").empty());
  PlanQuality creeping = good();
  creeping.speed_wanted = 0.002;
  creeping.speed_reached = 0.0015;
  EXPECT_TRUE(infeasible_reasons(true, creeping, "m/s").empty());
  creeping.speed_wanted = 0.02;
  creeping.speed_reached = 0.015;
  EXPECT_EQ(infeasible_reasons(true, creeping, "m/s").size(), 1u);
}

TEST(Feasibility, ATaskOnTheSpotNeedsNoSpeed) {
  PlanQuality still = good();
  still.speed_wanted = still.speed_reached = 0.0;
  EXPECT_TRUE(infeasible_reasons(true, still, "m/s").empty());
}

TEST(EarlyStop, ASearchThatDidNotEndIsToldInWords) {
  EXPECT_EQ(early_stop_words("interrupted"),
            "the search was interrupted: what is judged is the best so far, not its result");
  EXPECT_NE(early_stop_words("running").find("has not ended (status running)"), std::string::npos);
  RunRecord run;
  run.status = "interrupted";
  EXPECT_TRUE(run.stopped_early());
  run.status = "converged";
  EXPECT_FALSE(run.stopped_early());
}

}  // namespace
}  // namespace legwright
