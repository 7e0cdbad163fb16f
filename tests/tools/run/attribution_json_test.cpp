// SPDX-License-Identifier: Apache-2.0
#include "tools/run/attribution_json.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(AttributionJson, TermsByParameterInTheirOrder) {
  const std::vector<Attribution> written{{"yaw", {{"", "travel", -3.0}, {"", "smoothness", 1.5}}},
                                         {"idle", {}}};
  const Json document = to_json(written);
  EXPECT_EQ(document.dump(), R"({"yaw":{"travel":-3.0,"smoothness":1.5},"idle":{}})");
  EXPECT_EQ(to_json({}).dump(), "{}");
  const std::vector<Attribution> read = attributions_from_json(document, "pace");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].parameter, "yaw");
  ASSERT_EQ(read[0].shares.size(), 2U);
  EXPECT_EQ(read[0].shares[0].task, "pace");
  EXPECT_EQ(read[0].shares[0].term, "travel");
  EXPECT_EQ(read[0].shares[0].decrease, -3.0);
  EXPECT_EQ(read[0].shares[1].term, "smoothness");
  EXPECT_TRUE(read[1].shares.empty());
}

TEST(AttributionJson, WhatHasAnotherFormIsLeftOut) {
  EXPECT_TRUE(attributions_from_json(Json(3)).empty());
  EXPECT_TRUE(attributions_from_json(Json()).empty());
  const std::vector<Attribution> read = attributions_from_json(
      {{"worse", 3}, {"broken", {{"stance_foot", "x"}}}, {"small", {{"a", 0.1}, {"b", -0.2}}}});
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].parameter, "broken");
  EXPECT_TRUE(read[0].shares.empty());
  EXPECT_EQ(read[1].shares[0].term, "b") << "the largest comes first";
  EXPECT_EQ(read[1].shares[0].task, "");
}

}  // namespace
}  // namespace legwright
