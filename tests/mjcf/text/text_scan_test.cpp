// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/text_scan.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/text_edits.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

TEST(TextScan, FindsTagsBetweenCommentsAndQuotes) {
  const std::string text =
      "<?xml version='1.0'?>\n<!-- <no a=\"1\"/> --><a x = '1>2'\n  "
      "y=\"b'c\"><![CDATA[<no/>]]><b/><c></c></a>\n";
  const TagScan scan = scan_tags(text);
  ASSERT_EQ(scan.tags.size(), 3u);
  EXPECT_EQ(scan.stopped_line, 0);
  EXPECT_EQ(scan.tags[0].name, "a");
  EXPECT_EQ(scan.tags[0].line, 2);
  ASSERT_EQ(scan.tags[0].attributes.size(), 2u);
  const AttributeSpan& y = scan.tags[0].attributes[1];
  EXPECT_EQ(text.substr(y.value_begin, y.value_end - y.value_begin), "b'c");
  EXPECT_EQ(text.substr(y.begin, y.end - y.begin), "\n  y=\"b'c\"");
  EXPECT_EQ(scan.tags[1].depth, 2);
  EXPECT_EQ(scan.tags[2].name, "c");
}

TEST(TextScan, StopsAtBrokenMarkupAndSeesADoctype) {
  EXPECT_GT(scan_tags("<a x=1>").stopped_line, 0);
  EXPECT_GT(scan_tags("<a x=\"1").stopped_line, 0);
  EXPECT_GT(scan_tags("<!-- ").stopped_line, 0);
  EXPECT_EQ(scan_tags("\n\n<!DOCTYPE x><a/>").doctype_line, 3);
}

TEST(TextEdits, ChangesWordsAndKeepsTheOtherBytes) {
  const std::string text = "<m>\n  <b  pos='0   0 -0.060'/><!-- pos -->\n  <c/>\n</m>\n";
  const auto xml = load_xml(text, "m.xml");
  const XmlElement& b = *xml->root().FirstChildElement("b");
  const XmlElement& c = *xml->root().FirstChildElement("c");
  TextEdits edits(*xml);
  EXPECT_EQ(edits.apply(), text);
  edits.set_numbers(b, "pos", Eigen::Vector3d(0, 0.5, -0.06));
  edits.set(c, "axis", "0 1 0");
  edits.set(c, "pos", "1");
  EXPECT_EQ(
      edits.apply(),
      "<m>\n  <b  pos='0   0.5 -0.060'/><!-- pos -->\n  <c axis=\"0 1 0\" pos=\"1\"/>\n</m>\n");
  TextEdits removal(*xml);
  removal.remove(b, "pos");
  removal.remove(b, "none");
  EXPECT_EQ(removal.apply(), "<m>\n  <b/><!-- pos -->\n  <c/>\n</m>\n");
}

}  // namespace
}  // namespace legwright
