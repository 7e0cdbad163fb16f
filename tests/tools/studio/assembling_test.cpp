// SPDX-License-Identifier: Apache-2.0
// Robots that are made of modules, over HTTP.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/paths.hpp"
#include "tests/tools/studio/browser.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::OpenStudio;

class AssemblingTest : public testing::Test {
 protected:
  Json post(const std::string& path, const Json& body) { return studio_.browser->post(path, body); }
  Json put(const char* module, const char* spot) {
    return post("/api/assembly", {{"do", "put"}, {"module", module}, {"spot", spot}});
  }
  Json told() { return studio_.browser->next("assembly"); }
  void make_quadruped() {
    ASSERT_EQ(post("/api/open", {{"new_assembly", true}})["status"], 200);
    ASSERT_EQ(put("XL430-W250", "side/front")["item"], "limb/0/joint/0");
    ASSERT_EQ(put("XL430-W250", "limb/0/end")["item"], "limb/0/joint/1");
    ASSERT_EQ(
        post("/api/assembly", {{"do", "copy"}, {"item", "limb/0"}, {"spot", "side/hind"}})["item"],
        "limb/1");
  }

  OpenStudio studio_;
};

TEST_F(AssemblingTest, FromATrunkToARobotWithATaskAndBack) {
  EXPECT_EQ(put("XL430-W250", "side/front")["status"], 400) << "no assembly is open";
  make_quadruped();
  const Json made = told();
  EXPECT_EQ(made["servos"], 8) << "mirror images appear by themselves";
  EXPECT_EQ(made["items"].size(), made["design"]["bodies"].size());
  EXPECT_GT(made["mass"].get<double>(), 8 * 0.057);
  ASSERT_EQ(post("/api/assembly/build", Json::object())["status"], 200);
  EXPECT_FALSE(studio_.browser->next("motion").is_null());
  const Json opened = studio_.browser->next("opened");
  EXPECT_EQ(opened["of_modules"], true);
  EXPECT_EQ(opened["assembles"], false);
  ASSERT_EQ(post("/api/assembly/bench", Json::object())["status"], 200);
  EXPECT_EQ(studio_.browser->next("opened")["assembles"], true);
  EXPECT_EQ(told()["limbs"].size(), 2u) << "as it was left";
}

TEST_F(AssemblingTest, WhatWasDesignedGoesOnToTheNextBuildOfTheRobot) {
  make_quadruped();
  const auto build = [this] { return post("/api/assembly/build", Json::object()); };
  const auto document = [this] { return studio_.browser->get("/api/document"); };
  EXPECT_EQ(build()["carried"], "") << "nothing was designed before";
  const Json before = document();
  const Json& first = before["parameters"][0];
  const std::string name = first["name"];
  const double value = 0.5 * (first["given"].get<double>() + first["robot_upper"].get<double>());
  post("/api/command", {{"do", "edit"}, {"values", {{name, value}}}});
  post("/api/command", {{"do", "freeze"}, {"names", {name}}});
  const std::string narrow = before["parameters"][1]["name"];
  const double given = before["parameters"][1]["given"];
  const double upper = 0.5 * (given + before["parameters"][1]["robot_upper"].get<double>());
  ASSERT_EQ(
      post("/api/command",
           {{"do", "bounds"}, {"name", narrow}, {"lower", given}, {"upper", upper}})["status"],
      200);
  const Json slow{{"travel", {{"velocity", {0.031, 0.0}}}}};
  ASSERT_EQ(post("/api/task", {{"task", 0}, {"changes", slow}})["status"], 200);
  for (int again = 0; again < 2; ++again) {
    ASSERT_EQ(post("/api/assembly/bench", Json::object())["status"], 200);
    const std::string carried = build()["carried"];
    EXPECT_EQ(carried, "The task is that of before. Values of before: " + name +
                           ". Locked as before: " + name + ". Bounds as before: " + narrow + ".");
    const Json state = studio_.browser->next("state");
    EXPECT_EQ(state["s"][0], value);
    EXPECT_EQ(state["frozen"][0], true);
    EXPECT_EQ(state["lower"][1], given);
    EXPECT_EQ(state["upper"][1], upper);
    EXPECT_EQ(document()["tasks"][0]["velocity"][0], 0.031);
    EXPECT_EQ(studio_.browser->get("/api/start")["unsaved"].size(), 1U)
        << "what was only carried over is no work that may be missed";
  }
  ASSERT_EQ(post("/api/assembly/bench", Json::object())["status"], 200);
  ASSERT_EQ(post("/api/assembly", {{"do", "set"},
                                   {"item", "limb/0/joint/0"},
                                   {"key", "name"},
                                   {"value", "haunch"}})["status"],
            200);
  const std::string gone = build()["carried"];
  EXPECT_NE(gone.find("this robot has no such parameters: " + name), std::string::npos) << gone;
  ASSERT_EQ(post("/api/open", {{"path", test::kSidewaysTask}})["status"], 200);
  make_quadruped();
  EXPECT_EQ(build()["carried"], "") << "another assembly";
}

TEST_F(AssemblingTest, APageThatLooksAnewMissesNoNoticeOfWhatIsOpened) {
  make_quadruped();
  ASSERT_EQ(post("/api/assembly/build", Json::object())["status"], 200);
  const std::string name = studio_.browser->get("/api/document")["parameters"][0]["name"];
  post("/api/command", {{"do", "freeze"}, {"names", {name}}});
  (void)studio_.browser->settled();
  ASSERT_EQ(post("/api/assembly/bench", Json::object())["status"], 200);
  const auto heard = studio_.browser->next("opened")["heard"].get<std::uint64_t>();
  const auto told = [&](const std::string& path) {
    const auto any = [](const std::string& kind, const Json&) { return kind == "notice"; };
    return studio_.browser->follow(any, std::chrono::seconds(1), path);
  };
  const Json notice = told("/api/events?heard=" + std::to_string(heard));
  ASSERT_TRUE(notice.is_object());
  EXPECT_NE(notice["words"].get<std::string>().find("takes over"), std::string::npos) << notice;
  EXPECT_TRUE(told("/api/events?heard=x").is_null()) << "no number: notices from now on";
}

TEST_F(AssemblingTest, WhatIsRefusedChangesNothing) {
  make_quadruped();
  const auto revision = told()["revision"];
  const Json answer = put("XL430", "limb/0/end");
  EXPECT_EQ(answer["status"], 400);
  EXPECT_NE(answer["error"]["message"].get<std::string>().find("XL430"), std::string::npos);
  EXPECT_EQ(put("XL430-W250", "limb/7/end")["status"], 400);
  EXPECT_EQ(told()["revision"], revision);
}

TEST_F(AssemblingTest, IsSavedAsAFileThatIsReadBack) {
  make_quadruped();
  const std::string file = (studio_.folder.path() / "made.toml").string();
  EXPECT_EQ(post("/api/assembly/save", {{"path", "/etc/made.toml"}})["status"], 400);
  EXPECT_EQ(post("/api/assembly/save", {{"path", file}})["status"], 200);
  EXPECT_EQ(post("/api/assembly/save", {{"path", file}})["status"], 409) << "it is there already";
  EXPECT_EQ(post("/api/assembly/save", {{"path", file}, {"force", true}})["status"], 200);
  ASSERT_EQ(post("/api/open", {{"path", file}})["status"], 200);
  EXPECT_EQ(told()["limbs"].size(), 2u);
  EXPECT_EQ(studio_.browser->get("/api/start")["unsaved"].size(), 0u);
}

TEST_F(AssemblingTest, WhatIsLeftUnsavedIsTakenUpAgain) {
  make_quadruped();
  ASSERT_EQ(post("/api/open", {{"path", test::kSidewaysTask}})["status"], 200);
  const Json unsaved = studio_.browser->get("/api/start")["unsaved"];
  ASSERT_EQ(unsaved.size(), 1u);
  ASSERT_EQ(post("/api/open", {{"path", unsaved[0]["path"]}})["status"], 200);
  EXPECT_EQ(told()["servos"], 8);
  EXPECT_EQ(studio_.browser->get("/api/start")["unsaved"].size(), 0u) << "it is open";
}

TEST_F(AssemblingTest, ARobotThatDoesNotStandIsToldAndTheAssemblyStays) {
  ASSERT_EQ(post("/api/open", {{"new_assembly", true}})["status"], 200);
  EXPECT_NE(post("/api/assembly/build", Json::object())["error"]["message"].get<std::string>().find(
                "no limb yet"),
            std::string::npos);
  ASSERT_EQ(put("XL430-W250", "face/front")["status"], 200);
  EXPECT_EQ(post("/api/assembly/build", Json::object())["status"], 400);
  EXPECT_EQ(put("XL430-W250", "limb/0/end")["status"], 200);
}

TEST_F(AssemblingTest, ThePaletteHasAPictureOfEachModule) {
  const Json modules = studio_.browser->get("/api/modules")["modules"];
  EXPECT_GE(modules.size(), 20u);
  for (const Json& module : modules) {
    const Json picture =
        studio_.browser->get("/api/module?name=" + module["name"].get<std::string>());
    EXPECT_EQ(picture["status"], 200) << module;
    EXPECT_FALSE(picture["geoms"].empty()) << module;
  }
  EXPECT_EQ(studio_.browser->get("/api/module?name=none")["status"], 400);
}

}  // namespace
}  // namespace legwright
