// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page_template.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(PageTemplate, FillsEveryHoleAndEscapesText) {
  EXPECT_EQ(fill("<p title=\"{a}\">{b}, {a}</p>", {{"a", "x\"<y>"}, {"b", "1 & 2"}}),
            "<p title=\"x&quot;&lt;y&gt;\">1 &amp; 2, x&quot;&lt;y&gt;</p>");
  EXPECT_EQ(fill("<td>{cell}</td>", {Hole::markup("cell", "<b>1</b>")}), "<td><b>1</b></td>");
}

TEST(PageTemplate, DoubledBracesAreBraces) {
  EXPECT_EQ(fill("a {{b}} {c}", {{"c", "{d}"}}), "a {b} {d}");
}

TEST(PageTemplate, RefusesWhatDoesNotFit) {
  EXPECT_THROW(fill("{a}", {}), std::logic_error);
  EXPECT_THROW(fill("text", {{"a", "1"}}), std::logic_error);
  EXPECT_THROW(fill("{a", {{"a", "1"}}), std::logic_error);
  EXPECT_THROW(fill("a}", {}), std::logic_error);
}

}  // namespace
}  // namespace legwright
