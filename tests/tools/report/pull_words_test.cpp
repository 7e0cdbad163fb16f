// SPDX-License-Identifier: Apache-2.0
#include "tools/report/pull_words.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/run/attribution_json.hpp"

namespace legwright {
namespace {

const AttributionRecord kPull = {
    {"yaw", {{"smoothness", -1.58}, {"stance_foot", 14.3}, {"style_com", -2.6}, {"travel", 0.1}}},
    {"width", {{"style_com", -0.5}}},
    {"idle", {{"stance_foot", 0.01}}},
    {"broken", {{"stance_foot", NAN}}}};

TEST(PullWords, NamesWhatGainedFirstAndThenWhatItCost) {
  const auto pulls = attributions_of(kPull);
  ASSERT_EQ(pulls.size(), 4U);
  const double scale = largest_share(pulls);
  EXPECT_EQ(scale, 14.3);
  EXPECT_EQ(
      attribution_words(pulls[0], scale),
      "slip of stance feet −14.3, at the cost of body off its place +2.60, jerky joints +1.58");
  EXPECT_EQ(attribution_words(pulls[1], scale), "only at the cost of body off its place +0.50");
  EXPECT_EQ(attribution_words(pulls[2], scale), "") << "too little to be worth telling";
  EXPECT_EQ(attribution_words(pulls[3], scale), "");
}

TEST(PullWords, SumsUpOverAllParameters) {
  const auto pulls = attributions_of(kPull);
  const std::string sum = attribution_summary(pulls, 9.73);
  EXPECT_EQ(sum,
            "Taken together, the changes lowered F by 9.73. By term: slip of stance feet −14.3, at "
            "the cost of body off its place +3.10, jerky joints +1.58. Most came with yaw (−10.2) "
            "and idle (−0.01).");
  EXPECT_EQ(attribution_summary(pulls, std::nullopt), sum);
  EXPECT_EQ(attribution_summary(pulls, 100.0).substr(0, 41),
            "Of the 100 that F fell, 9.73 can be told ");
  EXPECT_EQ(attribution_summary({}, 1.0), "");
  EXPECT_EQ(attribution_summary(attributions_of({}), 1.0), "");
}

TEST(PullWords, ShowsAsManyDigitsAsMatter) {
  EXPECT_EQ(change_of_F(-14.28), "−14.3");
  EXPECT_EQ(change_of_F(2.816), "+2.82");
  EXPECT_EQ(change_of_F(0.00427), "+0.004");
}

TEST(PullWords, KeepsTasksApart) {
  auto pulls = attributions_of(AttributionRecord{{"yaw", {{"travel", 2.0}}}}, "pace");
  merge_attributions(pulls, attributions_of(AttributionRecord{{"yaw", {{"travel", -3.0}}},
                                                              {"roll", {{"travel", 1.0}}}},
                                            "walk"));
  ASSERT_EQ(pulls.size(), 2U);
  EXPECT_EQ(pulls[0].total("pace"), 2.0);
  EXPECT_EQ(pulls[0].total("walk"), -3.0);
  EXPECT_EQ(pulls[0].total(), -1.0);
  EXPECT_EQ(attribution_words(pulls[0], largest_share(pulls)),
            "walk: only at the cost of distance missed +3.00; pace: distance missed −2.00");
}

}  // namespace
}  // namespace legwright
