// SPDX-License-Identifier: Apache-2.0
#include "tools/run/attribution_json.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

TEST(AttributionJson, TermsByParameterInTheirOrder) {
  const std::vector<Attribution> written{{"yaw", {{"", "travel", -3.0}, {"", "smoothness", 1.5}}},
                                         {"idle", {}}};
  const AttributionRecord record = record_of(written);
  EXPECT_EQ(json_of(record).dump(), R"({"yaw":{"travel":-3.0,"smoothness":1.5},"idle":{}})");
  EXPECT_TRUE(record_of(std::vector<Attribution>{}).empty());
  const std::vector<Attribution> read = attributions_of(record, "pace");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].parameter, "yaw");
  ASSERT_EQ(read[0].shares.size(), 2U);
  EXPECT_EQ(read[0].shares[0].task, "pace");
  EXPECT_EQ(read[0].shares[0].term, "travel");
  EXPECT_EQ(read[0].shares[0].decrease, -3.0);
  EXPECT_EQ(read[0].shares[1].term, "smoothness");
  EXPECT_TRUE(read[1].shares.empty());
}

TEST(AttributionJson, LargestFirstAndWithoutWhatIsNoNumber) {
  EXPECT_TRUE(attributions_of({}).empty());
  const std::vector<Attribution> read = attributions_of(
      AttributionRecord{{"broken", {{"stance_foot", NAN}}}, {"small", {{"a", 0.1}, {"b", -0.2}}}});
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].parameter, "broken");
  EXPECT_TRUE(read[0].shares.empty());
  EXPECT_EQ(read[1].shares[0].term, "b") << "the largest comes first";
  EXPECT_EQ(read[1].shares[0].task, "");
}

}  // namespace
}  // namespace legwright
