// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace legwright {
namespace {

const WantedMotion kSideways{{0.0, 0.1}, 0.0};

Measurements good(double gain) {
  Measurements run;
  run.gain_scale = gain;
  run.cycles = 20;
  run.velocity = Eigen::Vector2d(0.004, 0.099);
  run.speed_ratio = 0.99;
  run.path_deviation = 0.02;
  run.tilt_max = 0.04;
  return run;
}

std::vector<Measurements> good_at_all() { return {good(0.5), good(1.0), good(2.0)}; }

TEST(Verdict, GoodRobotPassesAndSaysWhy) {
  const Verdict verdict = judge(good_at_all(), kSideways, "walk");
  EXPECT_TRUE(verdict.pass);
  EXPECT_TRUE(verdict.reasons.empty());
  EXPECT_EQ(verdict.line,
            "PASS  walk sideways at 0.100 m/s: 99 % of planned speed, tilt 0.04 rad, no fall "
            "(20 cycles; half, default and double gains)");
}

TEST(Verdict, ARobotThatTouchesItselfIsToldSo) {
  auto runs = good_at_all();
  runs[1].self_contact = {1.0, 3, 40.0, 2.0, "torso", "thigh"};
  const std::string words =
      "touches itself for 100 % of the time at default gains, hardest torso on thigh";
  Limits lenient = default_limits();
  lenient.erase("self_contact");
  const Verdict passing = judge(runs, kSideways, "walk", lenient);
  EXPECT_TRUE(passing.pass);
  EXPECT_NE(passing.line.find("; " + words), std::string::npos) << passing.line;
  runs[0].speed_ratio = 0.5;
  EXPECT_NE(judge(runs, kSideways, "walk", lenient).line.find(words), std::string::npos);
  runs[1].self_contact.share = 0.005;
  EXPECT_EQ(judge(runs, kSideways, "walk").line.find("touch"), std::string::npos);
}

TEST(Verdict, ARobotThatDragsOneLegOverTheOtherFails) {
  auto runs = good_at_all();
  runs[1].self_contact = {0.3, 3, 40.0, 2.0, "shank", "thigh", 0.0004};
  EXPECT_EQ(judge(runs, kSideways, "walk").line,
            "FAIL  walk sideways at 0.100 m/s: touches itself 30.0 % at default gains (of the "
            "time; up to 1 % pass); hardest touch: shank on thigh at default gains");
  runs[1].self_contact.share = 0.004;  // a blow is short, but deep
  EXPECT_TRUE(judge(runs, kSideways, "walk").pass);
  runs[1].self_contact.depth_max = 0.003;
  const Verdict struck = judge(runs, kSideways, "walk");
  ASSERT_EQ(struck.reasons.size(), 2U);
  EXPECT_NE(struck.reasons[0].find("0.003 m at default gains (up to 0.001 m passes)"),
            std::string::npos)
      << struck.line;
  EXPECT_NE(struck.reasons[1].find("shank on thigh"), std::string::npos) << struck.line;
}

TEST(Verdict, WhatMissesALimitByLittleReadsAsAMiss) {
  auto runs = good_at_all();
  runs[1].heading_drift = 20 * 0.010042;
  runs[2].saturated_share = 0.00098;  // "0.1 %", and passes
  runs[0].speed_ratio = 0.94997;
  const std::string line = judge(runs, kSideways, "walk").line;
  EXPECT_NE(line.find("by 0.01004 rad at default gains (a cycle; up to 0.01 rad passes)"),
            std::string::npos)
      << line;
  EXPECT_NE(line.find("94.997 % at half gains"), std::string::npos) << line;
  EXPECT_EQ(line.find("saturates"), std::string::npos) << line;
  runs[2].saturated_share = 0.001;  // has to be less
  EXPECT_NE(judge(runs, kSideways, "walk").line.find("0.1 % at double gains"), std::string::npos);
}

TEST(Verdict, AFailingServoIsNamed) {
  auto runs = good_at_all();
  runs[2].saturated_share = 0.13;
  runs[2].joints = {{"hip", 1.0, 2.0, 3.0, 0.01, 0.1, 1.4},
                    {"knee", 1.0, 3.0, 3.0, 0.12, 0.1, 0.6},
                    {"ankle", 1.0, 3.0, 3.0, 0.09, 0.1, 0.8},
                    {"toe", 1.0, 1.0, 3.0, 0.0, 0.1}};
  const Verdict verdict = judge(runs, kSideways, "walk");
  EXPECT_NE(verdict.line.find("saturates servos 13.0 % at double gains (of the time; less than "
                              "0.1 % pass; worst knee and ankle)"),
            std::string::npos)
      << verdict.line;
  const auto row = std::find_if(verdict.limits.begin(), verdict.limits.end(),
                                [](const auto& each) { return each.name == "saturated_share"; });
  ASSERT_EQ(row->worst.size(), 2U) << "the hip has less than half of what the knee has";
  EXPECT_EQ(row->worst[0].kind, "joint");
  EXPECT_EQ(row->worst[0].value, 0.12);
  EXPECT_EQ(row->worst[0].time, 0.6);
}

TEST(Verdict, AFailingFootIsNamed) {
  auto runs = good_at_all();
  for (const double slip : {0.001, 0.02}) {
    FootMeasures foot;
    foot.name = slip > 0.01 ? "left" : "right";
    foot.slip_max = slip;
    runs[1].feet.push_back(foot);
  }
  Limits limits = default_limits();
  limits["slip"].high = 0.01;
  const Verdict verdict = judge(runs, kSideways, "walk", limits);
  EXPECT_NE(verdict.line.find("(up to 0.01 m passes; worst left)"), std::string::npos)
      << verdict.line;
}

struct Case {
  const char* name;
  std::function<void(Measurements&)> change;
  bool pass;
  const char* words = "";
};

class VerdictTable : public testing::TestWithParam<Case> {};

TEST_P(VerdictTable, OneGainDecides) {
  for (std::size_t gain = 0; gain < 3; ++gain) {
    auto runs = good_at_all();
    GetParam().change(runs[gain]);
    const Verdict verdict = judge(runs, kSideways, "walk");
    EXPECT_EQ(verdict.pass, GetParam().pass) << verdict.line;
    EXPECT_EQ(verdict.reasons.empty(), GetParam().pass);
    EXPECT_NE(verdict.line.find(GetParam().words), std::string::npos) << verdict.line;
    if (!verdict.pass) {
      EXPECT_NE(verdict.line.find(gain_name(runs[gain].gain_scale)), std::string::npos)
          << verdict.line;
    }
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Limits, VerdictTable,
    testing::Values(
        Case{"slowest", [](Measurements& run) { run.speed_ratio = 0.95; }, true},
        Case{"too_slow", [](Measurements& run) { run.speed_ratio = 0.9499; }, false,
             "reaches 94.99 %"},
        Case{"fastest", [](Measurements& run) { run.speed_ratio = 1.05; }, true},
        Case{"too_fast", [](Measurements& run) { run.speed_ratio = 1.07; }, false,
             "reaches 107.0 %"},
        Case{"backs_off_a_hair", [](Measurements& run) { run.speed_ratio = -1e-5; }, false,
             "reaches 0.0 %"},
        Case{"backward", [](Measurements& run) { run.speed_ratio = -1.0; }, false,
             "reaches -100.0 %"},
        Case{"no_speed", [](Measurements& run) { run.speed_ratio.reset(); }, false, "unknown"},
        Case{"speed_is_no_number", [](Measurements& run) { run.speed_ratio = kNan; }, false,
             "unknown"},
        Case{"keeps_its_heading", [](Measurements& run) { run.heading_drift = -0.2; }, true},
        Case{"turns_away", [](Measurements& run) { run.heading_drift = -1.7; }, false,
             "drifts in heading by 0.085 rad"},
        Case{"turns_away_in_few_cycles",
             [](Measurements& run) {
               run.heading_drift = 0.1;
               run.cycles = 5;
             },
             false, "drifts in heading by 0.02 rad"},
        Case{"heading_is_no_number", [](Measurements& run) { run.heading_drift = kNan; }, false,
             "unknown"},
        Case{"stays_on_its_way", [](Measurements& run) { run.path_deviation = 0.1; }, true},
        Case{"leaves_its_way", [](Measurements& run) { run.path_deviation = 0.15; }, false,
             "goes astray by 15.0 %"},
        Case{"way_unknown", [](Measurements& run) { run.path_deviation.reset(); }, false,
             "unknown"},
        Case{"tilted", [](Measurements& run) { run.tilt_max = 0.1; }, false, "tilts by 0.100 rad"},
        Case{"tilt_is_no_number", [](Measurements& run) { run.tilt_max = kNan; }, false, "tilts"},
        Case{"hardly_saturated", [](Measurements& run) { run.saturated_share = 0.9e-3; }, true},
        Case{"saturated", [](Measurements& run) { run.saturated_share = 0.02; }, false,
             "saturates servos 2.0 %"},
        Case{"fell",
             [](Measurements& run) {
               run.fall = Fall{1.25, "the trunk sank"};
             },
             false, "falls after 1.25 s"},
        Case{"warned",
             [](Measurements& run) {
               run.warnings.push_back({0.5, "too many contacts", 3});
             },
             false, "MuJoCo warns after 0.50 s"},
        Case{"diverged", [](Measurements& run) { run.diverged = true; }, false, "diverged"}),
    [](const auto& param) { return param.param.name; });

TEST(Verdict, FirstCauseComesFirstAndConsequencesOfAFallAreLeftOut) {
  auto runs = good_at_all();
  runs[0].fall = Fall{1.0, "the trunk sank"};
  runs[0].speed_ratio = 0.3;
  runs[0].tilt_max = 0.9;
  runs[1].speed_ratio = 0.7;
  runs[2].warnings.push_back({0.5, "too many contacts", 3});
  const Verdict verdict = judge(runs, kSideways, "walk");
  ASSERT_EQ(verdict.reasons.size(), 3U);
  EXPECT_NE(verdict.reasons[0].find("MuJoCo warns"), std::string::npos);
  EXPECT_EQ(verdict.reasons[1], "falls after 1.00 s at half gains (the trunk sank)");
  EXPECT_EQ(verdict.reasons[2],
            "reaches 70.0 % at default gains (of the planned speed; 95 to 105 % pass)");
  EXPECT_EQ(verdict.line.rfind("FAIL  walk sideways at 0.100 m/s: ", 0), 0U);
}

TEST(Verdict, StandingIsJudgedByItsDrift) {
  const WantedMotion standing;
  auto runs = good_at_all();
  for (auto& run : runs) {
    run.speed_ratio.reset();
    run.velocity = Eigen::Vector2d(0.003, 0.0);
  }
  EXPECT_TRUE(judge(runs, standing, "walk").pass);
  EXPECT_EQ(describe(standing, "walk"), "walk on the spot");
  runs[1].velocity = Eigen::Vector2d(0.03, 0.0);
  EXPECT_FALSE(judge(runs, standing, "walk").pass);
  runs[1].velocity.reset();
  EXPECT_FALSE(judge(runs, standing, "walk").pass);
}

TEST(Verdict, TurningTaskNeedsTurning) {
  const WantedMotion turning{{0.1, 0.0}, 0.3};
  auto runs = good_at_all();
  for (auto& run : runs) run.turn_ratio = 0.95;
  EXPECT_TRUE(judge(runs, turning, "walk").pass);
  runs[2].turn_ratio = 0.1;
  EXPECT_FALSE(judge(runs, turning, "walk").pass);
}

TEST(Verdict, DirectionsHaveNames) {
  EXPECT_EQ(describe({{0.1, 0.0}, 0.0}, "trot"), "trot forward at 0.100 m/s");
  EXPECT_EQ(describe({{-0.1, 0.0}, 0.0}, "trot"), "trot backward at 0.100 m/s");
  EXPECT_EQ(describe({{0.0, -0.1}, 0.0}, "trot"), "trot sideways at 0.100 m/s");
  EXPECT_EQ(describe({{0.3, 0.4}, 0.0}, "trot"), "trot diagonally at 0.500 m/s");
  EXPECT_EQ(describe({{0.0, 0.0}, 0.5}, "trot"), "trot turning at 0.500 rad/s");
}

TEST(Verdict, NothingPlayedIsNoPass) {
  EXPECT_THROW(judge({}, kSideways, "walk"), std::invalid_argument);
}

}  // namespace
}  // namespace legwright
