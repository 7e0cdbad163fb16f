// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/junit.hpp"

#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace legwright {
namespace {

JunitSuite suite(const std::string& name) {
  JunitSuite out{name, {}};
  JudgedLimit good;
  good.name = "tilt";
  good.what = "largest tilt of the trunk";
  good.unit = "rad";
  good.bounds.high = 0.1;
  good.value = 0.04;
  good.pass = true;
  JudgedLimit bad = good;
  bad.name = "speed_ratio";
  bad.pass = false;
  bad.reason = "reaches 70 % <of> \"it\" & " + name;
  JudgedLimit unknown = good;
  unknown.value.reset();
  unknown.pass = false;
  out.verdict.limits = {good, bad, unknown};
  out.verdict.line = "FAIL  " + name;
  return out;
}

TEST(Junit, EachLimitIsACase) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(junit_xml({suite("pace"), suite("walk")}).c_str()),
            tinyxml2::XML_SUCCESS);
  const auto* root = document.RootElement();
  EXPECT_EQ(root->IntAttribute("tests"), 6);
  EXPECT_EQ(root->IntAttribute("failures"), 4);
  const auto* pace = root->FirstChildElement("testsuite");
  EXPECT_STREQ(pace->Attribute("name"), "pace");
  EXPECT_EQ(pace->IntAttribute("failures"), 2);
  const auto* one = pace->FirstChildElement("testcase");
  EXPECT_EQ(one->FirstChildElement("failure"), nullptr);
  const auto* failure = one->NextSiblingElement("testcase")->FirstChildElement("failure");
  ASSERT_NE(failure, nullptr);
  EXPECT_STREQ(failure->Attribute("message"), "reaches 70 % <of> \"it\" & pace");
}

TEST(Junit, AnErrorStandsInThePlaceOfAVerdict) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(junit_error_xml("my <run>", "a & b").c_str()), tinyxml2::XML_SUCCESS);
  const auto* suite = document.RootElement()->FirstChildElement("testsuite");
  EXPECT_EQ(document.RootElement()->IntAttribute("errors"), 1);
  EXPECT_STREQ(suite->Attribute("name"), "my <run>");
  const auto* error = suite->FirstChildElement("testcase")->FirstChildElement("error");
  ASSERT_NE(error, nullptr);
  EXPECT_STREQ(error->Attribute("message"), "a & b");
}

TEST(Junit, WhatWasJudgedIsAProperty) {
  JunitSuite one = suite("pace");
  one.of = {{"result/scene.xml", "0123"}};
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(junit_xml({one}).c_str()), tinyxml2::XML_SUCCESS);
  const auto* properties = document.RootElement()->FirstChildElement()->FirstChildElement();
  EXPECT_STREQ(properties->Name(), "properties");
  EXPECT_STREQ(properties->FirstChildElement()->Attribute("name"), "of result/scene.xml");
  EXPECT_STREQ(properties->FirstChildElement()->Attribute("value"), "0123");
  EXPECT_EQ(junit_xml({suite("pace")}).find("properties"), std::string::npos);
}

TEST(Junit, BoundsAreToldAsTheyAreJudged) {
  JunitSuite one = suite("pace");
  EXPECT_NE(junit_xml({one}).find("largest tilt of the trunk: 0.04 rad, at most 0.1<"),
            std::string::npos);
  for (auto& row : one.verdict.limits) row.strict = true;
  EXPECT_NE(junit_xml({one}).find("largest tilt of the trunk: 0.04 rad, less than 0.1<"),
            std::string::npos);
}

TEST(Junit, NamesFromAnywhereAreNoMarkup) {
  for (const std::string& name : std::vector<std::string>{
           std::string("<script>"), std::string("a\"b'c&d"), std::string("]]>"),
           std::string("\x01\x02\x1b[2J"), std::string("\xff\xfe"), std::string("\xef\xbf\xbf"),
           std::string("nul\0end", 7), std::string("line\nbreak"), std::string("\xed\xa0\x80")}) {
    const std::string text = junit_xml({suite(name)});
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(text.data(), text.size()), tinyxml2::XML_SUCCESS) << text;
    EXPECT_EQ(document.RootElement()->FirstChildElement("testsuite")->NextSiblingElement(),
              nullptr);
    for (const char c : text)
      EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << text;
    EXPECT_EQ(text.find("<script"), std::string::npos);
  }
}

}  // namespace
}  // namespace legwright
