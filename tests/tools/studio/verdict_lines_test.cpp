// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/verdict_lines.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

/// The line of one row, judged of a run that fell after 1.2 s at half gains and walked for 20 s at
/// double ones.
Json line_of(const LimitRow& row) {
  MetricsRecord metrics;
  GainMetrics half;
  half.fall = Fall{1.2, "tilted by more than 1 rad"};
  GainMetrics twice;
  twice.seconds = 20.0;
  metrics.result = {{"half", half}, {"double", twice}};
  return verdict_line(row, metrics, 0, "");
}

TEST(VerdictLines, ServosAtTheirLimitsAreNamedMarkedAndShown) {
  LimitRow row{
      "saturated_share", "share of the time with any servo at its limit", "1", {}, 1e-3, 0.13,
      "double gains"};
  row.worst = {{"joint", "FL_knee", 0.12, 0.6}, {"joint", "FR_knee", 0.11, 0.7}};
  const Json line = line_of(row);
  EXPECT_EQ(line["words"],
            "time with a servo at its torque limit: 13 % at double gains (at most 0.1 %); "
            "worst FL_knee (12 %) and FR_knee (11 %)");
  EXPECT_EQ(line["term"], "saturated_share: share of the time with any servo at its limit");
  EXPECT_EQ(line["moment"]["time"], 0.6);
  ASSERT_EQ(line["marks"].size(), 2U);
  EXPECT_EQ(line["marks"][0],
            Json({{"kind", "joint"},
                  {"name", "FL_knee"},
                  {"words", "FL_knee: servo at its limit for 12 % of the time"}}));
}

TEST(VerdictLines, AnglesAreToldInDegreesToo) {
  const LimitRow row{"tilt", "largest tilt of the trunk", "rad", {}, 0.35, 0.62, "half gains"};
  EXPECT_EQ(line_of(row)["words"],
            "largest tilt of the trunk: 0.62 rad (36°) at half gains (at most 0.35 rad (20°))");
}

TEST(VerdictLines, BodiesThatTouchAreBothMarked) {
  LimitRow row{
      "self_contact", "share of the time in which the robot touches itself", "1", {}, 0.01, 0.3,
      "double gains"};
  row.worst = {{"body", "FL_shank", {}, 2.1}, {"body", "HL_thigh", {}, 2.1}};
  const Json line = line_of(row);
  EXPECT_NE(line["words"].get<std::string>().find("; hardest between FL_shank and HL_thigh"),
            std::string::npos);
  EXPECT_EQ(line["moment"]["time"], 2.1);
  EXPECT_EQ(line["marks"][1]["words"], "HL_thigh touches FL_shank");
}

TEST(VerdictLines, AFallIsMarkedAtTheTrunkWithItsCause) {
  const LimitRow row{"falls",     "roll-outs in which the robot falls", "1", {}, 0.0, 1.0,
                     "half gains"};
  const Json line = line_of(row);
  EXPECT_EQ(line["moment"]["time"], 1.2);
  EXPECT_EQ(
      line["marks"],
      Json::array({{{"kind", "trunk"}, {"name", ""}, {"words", "tilted by more than 1 rad"}}}));
}

TEST(VerdictLines, WhatFailsOverAWholeWalkIsShownToTheEndOfTheWalkAtThoseGains) {
  LimitRow row{
      "speed_ratio", "measured over planned speed, along its heading", "1", 0.95, 1.05, 0.8,
      "double gains"};
  const Json line = line_of(row);
  EXPECT_EQ(line["moment"], Json({{"task", 0}, {"time", 20.0}, {"whole", true}}));
  EXPECT_EQ(line["marks"],
            Json::array(
                {{{"kind", "trunk"}, {"name", ""}, {"words", "speed, of the planned one: 80 %"}}}));
  row.pass = true;
  EXPECT_TRUE(line_of(row)["moment"].is_null());
  EXPECT_TRUE(line_of(row)["marks"].empty());
}

}  // namespace
}  // namespace legwright
