// SPDX-License-Identifier: Apache-2.0
// Which of the shares of terms and parameters are worth naming.
#include "optimizer/solve/attribution.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

Attribution make(std::string parameter, std::vector<AttributionShare> shares) {
  sort_by_size(shares);
  return {std::move(parameter), std::move(shares)};
}

std::vector<std::string> terms_of(const std::vector<AttributionShare>& shares) {
  std::vector<std::string> out;
  for (const AttributionShare& share : shares) out.push_back(share.term);
  return out;
}

using Names = std::vector<std::string>;

TEST(Attribution, MainSharesAreFewAndAboveTheThresholds) {
  const Attribution yaw =
      make("yaw", {{"", "a", -1.6}, {"", "b", 14.3}, {"", "c", -2.6}, {"", "d", 1.5}});
  EXPECT_EQ(terms_of(main_shares(yaw, 14.3)), (Names{"b", "c", "a"})) << "three at most";
  const Attribution small = make("roll", {{"", "a", 1.0}, {"", "b", 0.049}, {"", "c", -0.051}});
  EXPECT_EQ(terms_of(main_shares(small, 14.3)), (Names{"a", "c"})) << "5 % of the first";
  EXPECT_EQ(main_shares(small, 99.0).size(), 2U);
  EXPECT_TRUE(main_shares(small, 101.0).empty()) << "1 % of the scale";
  EXPECT_TRUE(main_shares(make("idle", {}), 1.0).empty());
}

TEST(Attribution, TasksKeepApartAndAddUp) {
  std::vector<Attribution> all{make("yaw", {{"pace", "travel", 2.0}})};
  merge_attributions(
      all, {make("yaw", {{"walk", "travel", -3.0}}), make("roll", {{"walk", "travel", 1.0}})});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].total("pace"), 2.0);
  EXPECT_EQ(all[0].total("walk"), -3.0);
  EXPECT_EQ(all[0].total(), -1.0);
  EXPECT_EQ(all[0].shares[0].task, "walk") << "the largest first";
  EXPECT_EQ(all[1].parameter, "roll");
  EXPECT_EQ(largest_share(all), 3.0);
  EXPECT_EQ(largest_share({}), 0.0);
}

TEST(Attribution, SummaryCountsWhatIsIdleAndSumsNothing) {
  const std::vector<Attribution> all{make("yaw", {{"", "a", 6.0}, {"", "b", -1.0}}),
                                     make("roll", {{"", "b", -2.0}, {"", "a", 1.0}}),
                                     make("pitch", {{"", "a", 0.11}, {"", "c", -0.02}}),
                                     make("unknown", {}), make("length", {{"", "d", 3.0}})};
  const auto summary = summarise(all, 10.0);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->count, 4U) << "nothing is known of one";
  EXPECT_EQ(summary->idle, 2U) << "one is worth 0.9 %, one less than nothing";
  ASSERT_EQ(summary->parameters.size(), 2U);
  EXPECT_EQ(summary->parameters[0].first, "yaw");
  EXPECT_EQ(summary->parameters[0].second, 5.0);
  EXPECT_EQ(summary->parameters[1].first, "length");
  EXPECT_EQ(summarise(all, 8.9)->idle, 1U);
  EXPECT_EQ(summarise(all, std::nullopt)->idle, 0U);
  EXPECT_FALSE(summarise({}, 1.0));
  EXPECT_FALSE(summarise({make("idle", {})}, 1.0));
  EXPECT_TRUE(summarise({make("worse", {{"", "a", -1.0}})}, std::nullopt)->parameters.empty());
}

TEST(Attribution, EffectsGoByDecreaseThenByShareOfTheRange) {
  const std::vector<ParameterEffect> effects{{-0.5, 0.9}, {0.0, 0.1}, {2.0, 0.1}, {0.0, 0.5}};
  EXPECT_EQ(order_of_effects(effects), (std::vector<std::size_t>{2, 3, 1, 0}));
  EXPECT_TRUE(order_of_effects({}).empty());
}

TEST(Attribution, MainEffectsAreFewAndAboveTheThreshold) {
  EXPECT_EQ(count_main_effects({{2.0, 0.1}, {0.11, 0.1}, {0.09, 0.1}}, true), 2U);
  EXPECT_EQ(count_main_effects({{2.0, 0.1}, {1.0, 0.1}, {0.5, 0.1}, {0.4, 0.1}}, true), 3U);
  EXPECT_EQ(count_main_effects({{0.0, 0.9}, {0.0, 0.5}, {0.0, 0.1}, {0.0, 0.0}}, false), 3U);
  EXPECT_EQ(count_main_effects({{2.0, 0.1}}, true), 1U);
  EXPECT_EQ(count_main_effects({}, true), 0U);
}

}  // namespace
}  // namespace legwright
