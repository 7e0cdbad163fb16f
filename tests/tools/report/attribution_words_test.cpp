// SPDX-License-Identifier: Apache-2.0
#include "tools/report/attribution_words.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/run/attribution_json.hpp"

namespace legwright {
namespace {

PutBackRecord row(const char* parameter, ByName<double> terms) {
  PutBackRecord out;
  out.parameter = parameter;
  for (const auto& [term, value] : terms) out.F += value;
  out.terms = std::move(terms);
  return out;
}

const std::vector<PutBackRecord> kRows = {
    row("yaw",
        {{"smoothness", -1.58}, {"stance_foot", 14.3}, {"style_com", -2.6}, {"travel", 0.1}}),
    row("width", {{"style_com", -0.5}}), row("idle", {{"stance_foot", 0.01}}),
    row("broken", {{"stance_foot", NAN}})};

TEST(AttributionWords, NamesWhatGainedFirstAndThenWhatItCost) {
  const auto rows = attributions_of(kRows);
  ASSERT_EQ(rows.size(), 4U);
  const double scale = largest_share(rows);
  EXPECT_EQ(scale, 14.3);
  EXPECT_EQ(
      attribution_words(rows[0], scale),
      "slip of stance feet −14.3, at the cost of body off its place +2.60, jerky joints +1.58");
  EXPECT_EQ(attribution_words(rows[1], scale), "only at the cost of body off its place +0.50");
  EXPECT_EQ(attribution_words(rows[2], scale), "") << "too little to be worth telling";
  EXPECT_EQ(attribution_words(rows[3], scale), "");
}

TEST(AttributionWords, NamesWhatBuysMostAndCountsWhatBuysNothing) {
  const auto rows = attributions_of(kRows);
  EXPECT_EQ(attribution_summary(rows, 9.73),
            "In the finished body F owes most to the change of yaw (−10.2) and of idle (−0.01). 2 "
            "of 3 changes could each be put back at less than 1 % of the fall of F.");
  EXPECT_EQ(attribution_summary(rows, std::nullopt),
            "In the finished body F owes most to the change of yaw (−10.2) and of idle (−0.01).");
  EXPECT_EQ(attribution_summary(attributions_of(std::vector{row("w", {{"travel", -1.0}})}), 1.0),
            "No change of the finished body lowers F by itself. 1 of 1 changes could each be put "
            "back at less than 1 % of the fall of F.");
  EXPECT_EQ(attribution_summary({}, 1.0), "");
  EXPECT_NE(std::string(kPutBackNote).find("do not add up"), std::string::npos);
}

TEST(AttributionWords, PutBackAlone) {
  EXPECT_EQ(put_back_words(3.14), "put back alone, F rises by 3.14");
  EXPECT_EQ(put_back_words(-0.02), "put back alone, F falls by 0.02");
  EXPECT_EQ(put_back_words(INFINITY), "put back alone, no motion is found");
}

TEST(AttributionWords, ShowsAsManyDigitsAsMatter) {
  EXPECT_EQ(change_of_cost(-14.28), "−14.3");
  EXPECT_EQ(change_of_cost(2.816), "+2.82");
  EXPECT_EQ(change_of_cost(0.00427), "+0.004");
}

TEST(AttributionWords, TellWhatPhysicsSaysOfAPutBackParameter) {
  EXPECT_EQ(put_back_words(3.1), "put back alone, F rises by 3.10");
  EXPECT_EQ(put_back_words(3.1, PlayedGait{0.0, true, ""}),
            "put back alone, F rises by 3.10, and MuJoCo still passes it");
  EXPECT_EQ(put_back_words(-0.5, PlayedGait{2.0, false, ""}),
            "put back alone, F falls by 0.50, and it fails in MuJoCo");
  EXPECT_EQ(put_back_words(INFINITY), "put back alone, no motion is found");

  std::vector<PutBackRecord> rows{row("hip_yaw", {}), row("shank", {}), row("width", {})};
  EXPECT_EQ(put_back_physics_words(std::nullopt), "");
  EXPECT_EQ(put_back_physics_words(rows), "") << "nothing was played";
  rows[0].played = {0.0, true, ""};
  EXPECT_EQ(
      put_back_physics_words(rows),
      "Put back alone, none of the 1 that buys 1 % of F or more lets the robot fail in MuJoCo "
      "within a few cycles.");
  rows[1].played = rows[2].played = {2.0, false, ""};
  EXPECT_EQ(
      put_back_physics_words(rows),
      "Put back alone, 2 of the 3 that buy 1 % of F or more let the robot fail in MuJoCo within "
      "a few cycles: shank and width.");
}

TEST(AttributionWords, KeepsTasksApart) {
  auto rows = attributions_of(std::vector{row("yaw", {{"travel", 2.0}})}, "pace");
  merge_attributions(rows, attributions_of(std::vector{row("yaw", {{"travel", -3.0}}),
                                                       row("roll", {{"travel", 1.0}})},
                                           "walk"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].total("pace"), 2.0);
  EXPECT_EQ(rows[0].total("walk"), -3.0);
  EXPECT_EQ(rows[0].total(), -1.0);
  EXPECT_EQ(attribution_words(rows[0], largest_share(rows)),
            "walk: only at the cost of distance missed +3.00; pace: distance missed −2.00");
}

}  // namespace
}  // namespace legwright
