// SPDX-License-Identifier: Apache-2.0
#include "tools/report/html.hpp"
#include "tools/files/clean_text.hpp"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <nlohmann/json.hpp>

#include "tests/tools/report/hostile_names.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLDocument;

TEST(Escape, ListOfHostileNamesIsLongEnough) { EXPECT_GE(hostile_names().size(), 40U); }

TEST(Escape, TextStaysTextInsideAnElement) {
  for (const std::string& name : hostile_names()) {
    Html page;
    page.open("div").element("p", name).close();
    XMLDocument document;
    ASSERT_EQ(document.Parse(page.take().c_str()), tinyxml2::XML_SUCCESS) << name;
    const auto* paragraph = document.RootElement()->FirstChildElement("p");
    ASSERT_NE(paragraph, nullptr) << name;
    EXPECT_EQ(paragraph->FirstChildElement(), nullptr) << name;
    EXPECT_EQ(paragraph->NextSibling(), nullptr) << name;
    const char* text = paragraph->GetText();
    EXPECT_EQ(text != nullptr ? text : "", clean_utf8(name)) << name;
  }
}

TEST(Escape, AttributeStaysOneAttribute) {
  for (const std::string& name : hostile_names()) {
    Html page;
    page.lone("img", {{"alt", name}});
    const std::string markup = page.take();
    XMLDocument document;
    ASSERT_EQ(document.Parse(markup.c_str()), tinyxml2::XML_SUCCESS) << markup;
    const auto* first = document.RootElement()->FirstAttribute();
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->Next(), nullptr) << name;
    EXPECT_EQ(first->Value(), clean_utf8(name)) << name;
    EXPECT_EQ(markup.find('<', 1), std::string::npos) << markup;
  }
}

TEST(Escape, JsonIslandCannotEndItsElementAndSaysTheSame) {
  for (const std::string& name : hostile_names()) {
    const nlohmann::json document{{"name", clean_utf8(name)}};
    const std::string island = escape_json_island(document.dump());
    EXPECT_EQ(island.find_first_of("<>&"), std::string::npos) << island;
    EXPECT_EQ(nlohmann::json::parse(island), document) << island;
  }
}

TEST(Escape, MarkdownHasNoLinksOrMarkupLeft) {
  EXPECT_EQ(escape_markdown("[x](http://e.org) <b> a|b"),
            "\\[x\\](http:\\/\\/e.org) &lt;b&gt; a\\|b");
}

TEST(Escape, UnescapedNameWouldBreakThePage) {  // negative control: the check above can fail
  XMLDocument document;
  EXPECT_NE(document.Parse("<p></p><script>alert(1)</p>"), tinyxml2::XML_SUCCESS);
}

TEST(CleanUtf8, ReplacesWhatIsNoText) {
  EXPECT_EQ(clean_utf8("a\tb\nc"), "a b c");
  EXPECT_EQ(clean_utf8("grün €"), "grün €");
  const std::string replacement = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_utf8(std::string("a\0b", 3)), "a" + replacement + "b");
  EXPECT_EQ(clean_utf8("\xC0\xAF"), replacement + replacement);         // overlong
  EXPECT_EQ(clean_utf8("\xED\xA0\x80").substr(0, 3), replacement);      // surrogate
  EXPECT_EQ(clean_utf8("\xF4\x90\x80\x80").substr(0, 3), replacement);  // beyond Unicode
  EXPECT_EQ(clean_utf8("\xE2\x82"), replacement + replacement);         // torn
  EXPECT_EQ(clean_utf8("\xE2\x80\xAE!"), replacement + "!");            // turns the text round
}

TEST(Html, InsistsOnBalance) {
  Html page;
  EXPECT_THROW(page.close(), std::logic_error);
  page.open("p");
  EXPECT_THROW(page.take(), std::logic_error);
}

TEST(DataUri, EncodesAsBase64) {
  const auto encoded = [](std::string_view text) {
    return data_uri("x", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encoded(""), "data:x;base64,");
  EXPECT_EQ(encoded("f"), "data:x;base64,Zg==");
  EXPECT_EQ(encoded("fo"), "data:x;base64,Zm8=");
  EXPECT_EQ(encoded("foobar"), "data:x;base64,Zm9vYmFy");
}

}  // namespace
}  // namespace legwright
