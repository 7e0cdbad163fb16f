// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/xml.hpp"

#include <gtest/gtest.h>

#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

std::string refusal(const std::string& text, const XmlLimits& limits = {}) {
  try {
    load_xml(text, "r.xml", limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Xml, PairsEveryElementOfThePuppyWithItsText) {
  const auto xml = load_xml(test::read_file(test::puppy_file()), "puppy");
  EXPECT_EQ(xml->tag_index.size(), xml->scan.tags.size());
  for (const auto& [element, index] : xml->tag_index)
    EXPECT_EQ(xml->scan.tags[index].line, element->GetLineNum());
}

TEST(Xml, LimitsHoldAtTheLimitAndOneBeyond) {
  const std::string a = "<m><a/><a/></m>";
  EXPECT_EQ(refusal(a, {.bytes = a.size()}), "accepted");
  EXPECT_NE(refusal(a, {.bytes = a.size() - 1}).find("larger than"), std::string::npos);
  EXPECT_EQ(refusal(a, {.elements = 3}), "accepted");
  EXPECT_NE(refusal(a, {.elements = 2}).find("r.xml:1: more than 2 elements"), std::string::npos);
  EXPECT_EQ(refusal("<m><a x='12'/></m>", {.attribute_bytes = 2}), "accepted");
  EXPECT_NE(refusal("<m><a x='123'/></m>", {.attribute_bytes = 2}).find("attribute 'x'"),
            std::string::npos);
  EXPECT_EQ(refusal("<m><a><b/></a></m>", {.depth = 3}), "accepted");
  EXPECT_NE(refusal("<m>\n<a>\n<b/></a></m>", {.depth = 2}).find("r.xml:3: b: elements are nested"),
            std::string::npos);
}

TEST(Xml, RefusesDeepNestingDoctypeAndForeignBytes) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_NE(refusal(deep).find("r.xml"), std::string::npos);
  EXPECT_NE(refusal("<!DOCTYPE m><m/>").find("DOCTYPE"), std::string::npos);
  EXPECT_NE(refusal("<m>\n\xff</m>").find("r.xml:2: a byte that is no UTF-8"), std::string::npos);
  EXPECT_NE(refusal(std::string("<m>\0</m>", 8)).find("UTF-8"), std::string::npos);
  EXPECT_NE(refusal("<m a='\xc0\xaf'/>").find("UTF-8"), std::string::npos);      // overlong
  EXPECT_NE(refusal("<m a='\xed\xa0\x80'/>").find("UTF-8"), std::string::npos);  // surrogate
  EXPECT_EQ(refusal("<m a='\xc3\xa4\xe2\x82\xac\xf0\x9f\x90\xb6'/>"), "accepted");
  EXPECT_NE(refusal("").find("r.xml"), std::string::npos);
  EXPECT_NE(refusal("<m><a></m>").find("not closed"), std::string::npos);
}

TEST(Xml, ResolvesDefaultsByClassChildclassAndEnclosingClass) {
  const auto xml = load_xml(R"(<mujoco>
    <default><geom size="1" pos="1 1 1"/><default class="leg"><geom size="2"/>
      <default class="foot"><geom type="box"/></default></default></default>
    <worldbody><geom name="a"/><body childclass="leg"><geom name="b"/>
    <frame><geom name="c" class="foot"/></frame>
    <body><geom name="d" size="9"/><site name="e"/></body></body></worldbody></mujoco>)",
                            "r.xml");
  const auto value = [&](const char* tag, const char* name, const char* what) {
    const char* found = inherited_attribute(*xml, *find_named(xml->root(), tag, name), what);
    return std::string(found ? found : "none");
  };
  EXPECT_EQ(value("geom", "a", "size"), "1");
  EXPECT_EQ(value("geom", "b", "size"), "2");
  EXPECT_EQ(value("geom", "b", "pos"), "1 1 1");
  EXPECT_EQ(value("geom", "c", "type"), "box");
  EXPECT_EQ(value("geom", "c", "size"), "2");
  EXPECT_EQ(value("geom", "d", "size"), "9");
  EXPECT_EQ(value("geom", "b", "type"), "none");
  EXPECT_EQ(value("site", "e", "pos"), "none");
}

}  // namespace
}  // namespace legwright
