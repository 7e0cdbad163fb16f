// SPDX-License-Identifier: Apache-2.0
#include "tools/report/svg_bars.hpp"

#include <gtest/gtest.h>

#include <string>

namespace legwright {
namespace {

/// The x and width of the first rectangle of a style; −1 without one.
std::pair<double, double> rectangle(const std::string& svg, const std::string& style) {
  const auto at = svg.find("class=\"" + style + "\"");
  if (at == std::string::npos) return {-1.0, -1.0};
  return {std::stod(svg.substr(svg.find("x=\"", at) + 3)),
          std::stod(svg.substr(svg.find("width=\"", at) + 7))};
}

TEST(BoundsBar, KeepsMarksWithinTheTrack) {
  const auto bar = bounds_bar(0.0, 1.0, 0.5, 7.0);
  EXPECT_NE(bar.find("class=\"after\" cx=\"113.0\""), std::string::npos);
  EXPECT_NE(bar.find("class=\"before\" cx=\"60.0\""), std::string::npos);
  EXPECT_TRUE(bounds_bar(1.0, 1.0, 1.0, 1.0).empty());
}

TEST(RangeBar, DividesTheRangeWhereItStopsWalking) {
  const auto [x, width] = rectangle(
      range_bar({.tested_low = 0.0, .tested_high = 4.0, .low = 1.0, .high = 3.0}), "walks");
  EXPECT_NEAR(x, 2.0 + 79.0, 0.06);
  EXPECT_NEAR(width, 158.0, 0.06);
}

TEST(RangeBar, WalksToTheEndWhereItNeverFell) {
  const std::string bar = range_bar({.tested_low = 0.0, .tested_high = 4.0, .low = 1.0});
  const auto [x, width] = rectangle(bar, "walks");
  EXPECT_NEAR(x + width, 318.0, 0.11);
  EXPECT_EQ(bar.find("falls", bar.find("falls") + 1), std::string::npos) << "one part only";
}

TEST(RangeBar, WideRangesHaveALogAxis) {
  const auto wide =
      rectangle(range_bar({.tested_low = 0.1, .tested_high = 10.0, .low = 1.0}), "walks");
  EXPECT_NEAR(wide.first, 160.0, 0.06);  // 1 is in the middle of 0.1 … 10
  const auto narrow =
      rectangle(range_bar({.tested_low = 0.5, .tested_high = 2.0, .low = 1.0}), "walks");
  EXPECT_NEAR(narrow.first, 2.0 + 316.0 / 3.0, 0.06);
}

TEST(RangeBar, ValuesOutsideStayOnTheBar) {
  const std::string bar = range_bar(
      {.tested_low = 0.1, .tested_high = 10.0, .low = -3.0, .high = 99.0, .nominal = 0.0});
  const auto [x, width] = rectangle(bar, "walks");
  EXPECT_GE(x, 2.0);
  EXPECT_LE(x + width, 318.05);
  EXPECT_TRUE(range_bar({.tested_low = 1.0, .tested_high = 1.0}).empty());
}

TEST(ShareBar, IsAsLongAsTheShare) {
  EXPECT_NEAR(rectangle(share_bar(0.25, 0.2, 0.3), "walks").second, 79.0, 0.06);
  EXPECT_TRUE(share_bar(std::nullopt, 0.1, 0.2).empty());
  EXPECT_EQ(share_bar(0.5, std::nullopt, std::nullopt).find("end"), std::string::npos);
}

}  // namespace
}  // namespace legwright
