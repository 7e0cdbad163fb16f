// SPDX-License-Identifier: Apache-2.0
// Robots that declare nothing, dropped onto the Studio as they lie on a disk.
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tools/studio/browser.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/base64.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::Browser;
using test::OpenStudio;

/// All files below a folder as a page sends them.
Json sent(const fs::path& folder) {
  Json files = Json::array();
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), folder.parent_path()).generic_string();
    files.push_back({{"name", name}, {"base64", base64_of(read_file(entry.path()))}});
  }
  return files;
}

std::string without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return text.erase(at, text.find(to, at) + to.size() - at);
}

/// The puppy, which declares nothing.
std::string plain_puppy() {
  return without(read_file(test::source_dir() + "/examples/puppy/robot.xml"), "<custom>",
                 "</custom>");
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string told(const Json& found) { return found["told"].dump(); }

/// One file as a page sends it.
Json sent(const std::string& name, const std::string& text) {
  return Json::array({{{"name", name}, {"base64", base64_of(text)}}});
}

/// What is found of files that are dropped.
Json proposal_of(Browser& browser, const Json& files) {
  EXPECT_EQ(browser.post("/api/open", {{"files", files}})["status"], 200);
  return browser.get("/api/proposal");
}

Json all_names(const Json& found) {
  Json names = Json::array();
  for (const Json& one : found["parameters"]) names.push_back(one["name"]);
  return names;
}

TEST(Proposing, ARobotWithoutParametersIsProposedAndThenOpened) {
  OpenStudio studio;
  Browser& browser = *studio.browser;
  EXPECT_EQ(browser.post("/api/command", {{"do", "start"}})["status"], 400) << "nothing is open";
  const std::string plain = plain_puppy();
  ASSERT_EQ(browser.post("/api/open", {{"files", sent("dropped/mine.xml", plain)}})["status"], 200);
  EXPECT_TRUE(browser.next("opened")["proposes"].get<bool>());
  const Json found = browser.get("/api/proposal");
  EXPECT_EQ(found["limbs"].size(), 4U);
  ASSERT_GT(found["parameters"].size(), 10U);
  const std::string first = found["parameters"][0]["name"], second = found["parameters"][1]["name"];
  EXPECT_EQ(browser.post("/api/proposal", {{"parameters", {"tail"}}})["status"], 400);
  ASSERT_EQ(browser.post("/api/proposal",
                         {{"parameters", {first, second}}, {"path", "mine.xml"}})["status"],
            200);
  const Json document = browser.get("/api/document");
  EXPECT_EQ(document["parameters"].size(), 2U);
  EXPECT_EQ(document["tasks"][0]["gait"], "trot");
  EXPECT_NE(read_file(studio.folder.path() / "mine.xml").find("legwright/" + first),
            std::string::npos);
}

/// Declares nothing, and its trunk is fixed to the world.
TEST(Proposing, ATrunkThatIsFixedFloatsAndIsToldSo) {
  const std::string plain =
      without(without(plain_puppy(), "<freejoint", "/>"), "<keyframe>", "</keyframe>");
  OpenStudio studio;
  Browser& browser = *studio.browser;
  const Json found = proposal_of(browser, sent("mine.xml", plain));
  EXPECT_TRUE(contains(told(found), "free joint")) << found.dump(1);
  ASSERT_EQ(browser.post("/api/proposal", {{"parameters", all_names(found)}})["status"], 200);
  EXPECT_GT(browser.get("/api/document")["parameters"].size(), 10U);
}

TEST(Proposing, ARobotThatDoesNotStandAsDrawnGetsAPose) {
  OpenStudio studio;
  Browser& browser = *studio.browser;
  const Json found =
      proposal_of(browser, sent(fs::path(test::source_dir()) / "tests/robots/lurcher"));
  EXPECT_TRUE(contains(told(found), "a pose to stand in is found for it")) << found.dump(1);
  ASSERT_EQ(browser.post("/api/proposal", {{"parameters", all_names(found)}})["status"], 200);
  EXPECT_EQ(browser.get("/api/document")["tasks"][0]["gait"], "trot");
}

TEST(Proposing, AUrdfWithItsMeshesIsReadAsMjcf) {
  OpenStudio studio;
  Browser& browser = *studio.browser;
  const Json found =
      proposal_of(browser, sent(fs::path(test::source_dir()) / "tests/robots/hound"));
  EXPECT_EQ(found["limbs"].size(), 4U);
  EXPECT_TRUE(contains(told(found), "has no mass and is left out")) << found.dump(1);
  ASSERT_EQ(browser.post("/api/proposal", {{"parameters", all_names(found)}})["status"], 200);
  const Json document = browser.get("/api/document");
  EXPECT_EQ(document["parameters"].size(), found["parameters"].size());
  EXPECT_GT(browser.get("/api/design")["bodies"].size(), 8U);
}

TEST(Proposing, WhereARobotFacesCanBeSaid) {
  OpenStudio studio;
  Browser& browser = *studio.browser;
  const std::string plain = plain_puppy();
  EXPECT_EQ(proposal_of(browser, sent("mine.xml", plain))["ahead"], "+x");
  const Json found = browser.get("/api/proposal?forward=-x");
  EXPECT_EQ(found["ahead"], "-x");
  EXPECT_EQ(browser.get("/api/proposal?forward=up")["status"], 400);
  ASSERT_EQ(browser.post("/api/proposal",
                         {{"parameters", all_names(found)}, {"forward", "-x"}})["status"],
            200);
  for (const auto& entry : fs::recursive_directory_iterator(studio.folder.path() / "state"))
    if (entry.path().filename() == "session.jsonl") {
      EXPECT_TRUE(contains(read_file(entry.path()), "forward = \\\"-x\\\""));
      return;
    }
  FAIL() << "no journal has its task";
}

TEST(Proposing, WhatCannotBeMadeReadySaysWhy) {
  OpenStudio studio;
  const std::string loose =
      "<mujoco><worldbody><body name=\"box\"><geom size=\".1\"/></body>"
      "</worldbody></mujoco>";
  const Json answer = studio.browser->post("/api/open", {{"files", sent("box.xml", loose)}});
  EXPECT_EQ(answer["status"], 400);
  EXPECT_TRUE(contains(answer.dump(), "box.xml:1: body 'box': no free root")) << answer.dump(1);
}

}  // namespace
}  // namespace legwright
