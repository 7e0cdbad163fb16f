// SPDX-License-Identifier: Apache-2.0
// Sessions that were left behind, some of them damaged, copied or held.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/paths.hpp"
#include "tests/tools/studio/browser.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::Browser;
using test::OpenStudio;

class KeptSessionsTest : public testing::Test {
 protected:
  Json open(const std::string& path) { return browser_.post("/api/open", {{"path", path}}); }
  Json edit(double value) {
    return browser_.post("/api/command",
                         {{"do", "edit"}, {"values", {{"front_thigh_length", value}}}});
  }
  Json unsaved() { return browser_.get("/api/start")["unsaved"]; }
  /// The folder of a session that was left with an edit; the same task is open.
  fs::path left() {
    EXPECT_EQ(open(test::kSidewaysTask)["status"], 200);
    EXPECT_EQ(edit(0.061)["status"], 200);
    EXPECT_EQ(open(test::kSidewaysTask)["status"], 200);
    const Json found = unsaved();
    return found.size() == 1 ? found[0]["path"].get<std::string>() : std::string();
  }

  OpenStudio studio_;
  Browser& browser_ = *studio_.browser;
};

TEST_F(KeptSessionsTest, OneThatIsDamagedHindersNothingAndIsTakenUp) {
  const fs::path folder = left();
  ASSERT_FALSE(folder.empty());
  write_file(folder / "about.json", "");  // as after the power failed
  ASSERT_EQ(browser_.get("/api/start")["status"], 200);
  ASSERT_EQ(open(test::kSidewaysTask)["status"], 200);
  const Json found = unsaved();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["name"], folder.filename().string());
  ASSERT_EQ(open(folder.string())["status"], 200);
  EXPECT_EQ(browser_.next("state")["s"][0], 0.061);
}

TEST_F(KeptSessionsTest, OneThatCannotBeLockedIsPassedOver) {
  const fs::path folder = left();
  ASSERT_FALSE(folder.empty());
  fs::remove(folder / "lock");
  fs::create_directory(folder / "lock");
  EXPECT_EQ(browser_.get("/api/start")["status"], 200);
  EXPECT_EQ(unsaved().size(), 0U);
  EXPECT_EQ(open(test::kSidewaysTask)["status"], 200);
}

TEST_F(KeptSessionsTest, ACopyStaysWhereItIs) {
  const fs::path copy = studio_.folder.path() / "copy";
  fs::copy(left(), copy, fs::copy_options::recursive);
  ASSERT_EQ(open(copy.string())["status"], 200);
  EXPECT_EQ(browser_.next("state")["s"][0], 0.061);
  EXPECT_TRUE(fs::is_regular_file(copy / "session.jsonl"));
}

TEST_F(KeptSessionsTest, OneThatAStudioWorksOnIsRefusedAndStays) {
  ASSERT_EQ(open(test::kSidewaysTask)["status"], 200);
  ASSERT_EQ(edit(0.061)["status"], 200);
  const std::string live = browser_.next("opened")["kept"];
  const Json answer = open(live);
  EXPECT_EQ(answer["status"], 400);
  EXPECT_NE(answer["error"]["message"].get<std::string>().find("a studio works on"),
            std::string::npos);
  EXPECT_TRUE(fs::is_regular_file(fs::path(live) / "session.jsonl"));
  EXPECT_EQ(edit(0.062)["status"], 200) << "it goes on";
}

TEST(KeptFolderTest, AFolderWhoseNameIsNoTextIsOpened) {
  OpenStudio studio;
  const fs::path folder = studio.folder.path() / "caf\xE9";
  fs::create_directory(folder);
  for (const char* name : {"robot.xml", "sideways.toml"})
    fs::copy_file(fs::path(test::kSidewaysTask).parent_path() / name, folder / name);
  EXPECT_NO_THROW(studio.service.open((folder / "sideways.toml").string()));
  EXPECT_TRUE(studio.browser->next("opened").is_object());
}

}  // namespace
}  // namespace legwright
