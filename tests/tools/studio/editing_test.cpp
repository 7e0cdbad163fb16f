// SPDX-License-Identifier: Apache-2.0
// Co-design over HTTP, as a page does it.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "tests/support/paths.hpp"
#include "tests/tools/studio/browser.hpp"
#include "tools/files/base64.hpp"

namespace legwright {
namespace {

using test::Browser;
using test::OpenStudio;

/// The puppy that shall walk sideways, planned at half the points: what the server tells of a
/// session does not hang on them, how long it takes does.
std::string coarse_sideways() {
  std::string text = read_file(test::kSidewaysTask);
  const auto put = [&text](const std::string& what, const std::string& instead) {
    text.replace(text.find(what), what.size(), instead);
  };
  put("knots = 24", "knots = 12");
  put("\"robot.xml\"", "\"" + test::source_dir() + "/examples/puppy/robot.xml\"");
  return text;
}

class EditingTest : public testing::Test {
 protected:
  EditingTest() {
    write_file(task_, coarse_sideways());
    studio_.service.open(task_);
  }
  Json command(const Json& body) { return browser_.post("/api/command", body); }
  static double value(const Json& state) { return state["s"][0].get<double>(); }

  OpenStudio studio_;
  Browser& browser_ = *studio_.browser;
  const std::string task_ = (studio_.folder.path() / "sideways.toml").string();
};

constexpr const char* kThigh = "front_thigh_length";

TEST_F(EditingTest, ANewPageIsToldEverythingThatIsPresent) {
  (void)browser_.settled();
  std::string kinds;
  Json motion;
  browser_.follow([&](const std::string& kind, const Json& data) {
    kinds += kind + " ";
    if (kind == "motion") motion = data;
    return kind == "state";
  });
  for (const char* kind : {"opened ", "design ", "motion ", "state "})
    EXPECT_NE(kinds.find(kind), std::string::npos) << kinds;
  const auto frames = motion["frames"].get<std::size_t>(),
             bodies = motion["bodies"].get<std::size_t>();
  EXPECT_EQ(from_base64(motion["poses"].get<std::string>())->size(), frames * bodies * 7 * 4);
  EXPECT_EQ(motion["feet"].size(), 4U);
  EXPECT_FALSE(motion["predicted"].get<bool>());
  EXPECT_FALSE(motion["faults"].empty()) << "as it is built the puppy cannot walk sideways";
}

TEST_F(EditingTest, AnEditIsDrawnAndSolvedAndUndone) {
  (void)browser_.settled();
  EXPECT_EQ(command({{"do", "edit"}, {"values", {{kThigh, 0.061}}}})["status"], 200);
  const Json moved = browser_.settled();
  EXPECT_EQ(value(moved), 0.061);
  EXPECT_TRUE(moved["can_undo"].get<bool>());
  EXPECT_EQ(command({{"do", "undo"}})["status"], 200);
  EXPECT_EQ(value(browser_.settled()), 0.06);
  EXPECT_EQ(command({{"do", "edit"}, {"values", {{kThigh, 0.06}}}, {"held", "yes"}})["status"],
            400);
  const Json refused = command({{"do", "edit"}, {"values", {{kThigh, 9.0}}}});
  EXPECT_EQ(refused["status"], 400);
  EXPECT_NE(refused["error"]["message"].get<std::string>().find("its bounds"), std::string::npos);
  EXPECT_EQ(refused["error"]["where"], kThigh);
  EXPECT_EQ(refused["error"]["message"].get<std::string>().find("front_thigh_length: is to be"), 0U)
      << "its place once, and no file";
}

TEST_F(EditingTest, KeysThatUndoWhereThereIsNothingAreNoFault) {
  (void)browser_.settled();
  for (const char* key : {"undo", "redo"}) EXPECT_EQ(command({{"do", key}})["status"], 200) << key;
  EXPECT_EQ(command({{"do", "undo"}, {"steps", 2}})["status"], 400);
}

TEST_F(EditingTest, UndoAndEditsInterruptASearch) {
  (void)browser_.settled();
  command({{"do", "edit"}, {"values", {{kThigh, 0.061}}}});
  command({{"do", "start"}});
  const Json point = browser_.next("point", [](const Json& p) { return !p["changed"].empty(); });
  ASSERT_FALSE(point.is_null());
  EXPECT_GT(point["iteration"].get<int>(), 0);
  EXPECT_EQ(command({{"do", "undo"}})["status"], 200);  // the search
  EXPECT_EQ(value(browser_.settled()), 0.061);
  command({{"do", "start"}});
  command({{"do", "edit"}, {"values", {{kThigh, 0.062}}}});
  EXPECT_EQ(value(browser_.settled()), 0.062);
}

TEST_F(EditingTest, ABrowserThatComesBackIsAtThePresent) {
  (void)browser_.settled();
  command({{"do", "edit"}, {"values", {{kThigh, 0.064}}}});
  (void)browser_.settled();
  Browser second(studio_.server->url());
  EXPECT_EQ(value(second.settled()), 0.064);
  EXPECT_EQ(second.post("/api/command", {{"do", "undo"}})["status"], 200);
  EXPECT_EQ(value(second.settled()), 0.06);
  EXPECT_EQ(value(browser_.settled()), 0.06) << "the first one follows";
}

TEST_F(EditingTest, TasksChangeByTheirKeys) {
  const Json before = browser_.get("/api/document");
  const auto change = [&](Json changes) {
    return browser_.post("/api/task", {{"task", 0}, {"changes", std::move(changes)}});
  };
  EXPECT_EQ(
      change({{"travel", {{"velocity", {0.05, 0.0}}}}, {"gait", {{"period", 0.8}}}})["status"],
      200);
  EXPECT_EQ(change({{"payload", {{"mass", 0.5}}}})["status"], 200);
  Json task = browser_.get("/api/document")["tasks"][0];
  EXPECT_EQ(task["velocity"], Json::array({0.05, 0.0}));
  EXPECT_EQ(task["period"], 0.8);
  EXPECT_EQ(task["payload"], 0.5);
  const Json motion = browser_.next("motion", [](const Json& m) { return !m["extra"].empty(); });
  EXPECT_EQ(motion["extra"][0]["name"], "payload");
  EXPECT_EQ(change({{"payload", nullptr}})["status"], 200);
  EXPECT_EQ(browser_.get("/api/document")["tasks"][0]["payload"], nullptr);
  for (const Json& no_task : {Json(4294967296), Json(0.7), Json(1e300), Json("0")}) {
    const Json body{{"task", no_task}, {"changes", Json::object()}};
    const Json answer = browser_.post("/api/task", body);
    EXPECT_EQ(answer["status"], 400) << no_task;
    const std::string told = answer["error"]["message"];
    EXPECT_NE(told.find("expected a whole number"), std::string::npos) << told;
  }
  const Json refused = change({{"gait", {{"perriod", 0.8}}}});
  EXPECT_EQ(refused["status"], 400);
  EXPECT_NE(refused["error"]["message"].get<std::string>().find("period"), std::string::npos);
  EXPECT_EQ(refused["error"]["message"].get<std::string>().find("sideways.toml:"), 0U) << refused;
  EXPECT_GT(browser_.settled()["document"].get<int>(), before["document"].get<int>());
}

TEST_F(EditingTest, FootfallsComeBackAsTheyWereDrawn) {
  studio_.service.open(test::kSidewaysTask);  // at 24 knots
  const Json cells = browser_.get("/api/document")["tasks"][0]["footfalls"];
  const auto knots = cells[0]["cells"].size();
  Json touchdown, duty;
  std::size_t first = 3;
  for (const Json& row : cells) {  // each foot stands for 15 knots, one after the other
    touchdown[row["foot"].get<std::string>()] =
        static_cast<double>(first) / static_cast<double>(knots);
    duty[row["foot"].get<std::string>()] = 15.0 / static_cast<double>(knots);
    first += 6;
  }
  const Json answer = browser_.post(
      "/api/task",
      {{"task", 0},
       {"changes", {{"gait", {{"name", "mine"}, {"touchdown", touchdown}, {"duty", duty}}}}}});
  ASSERT_EQ(answer["status"], 200) << answer;
  const Json task = browser_.get("/api/document")["tasks"][0];
  EXPECT_EQ(task["gait_kind"], "own");
  first = 3;
  for (const Json& row : task["footfalls"]) {
    for (std::size_t k = 0; k < knots; ++k)
      EXPECT_EQ(row["cells"][k], (k + knots - first) % knots < 15 ? 1 : 0) << row["foot"] << k;
    first = (first + 6) % knots;
  }
}

TEST_F(EditingTest, WhatCannotBeOpenedLeavesWhatIsOpen) {
  const auto task = studio_.folder.path() / "canter.toml";
  std::string wrong = coarse_sideways();
  wrong.replace(wrong.find("name = \"walk\""), 13, "name = \"tripod\"");
  write_file(task, wrong);
  const Json answer = browser_.post("/api/open", {{"path", task.string()}});
  EXPECT_EQ(answer["status"], 400);
  EXPECT_GT(answer["error"]["line"].get<int>(), 0);
  EXPECT_EQ(browser_.get("/api/document")["path"], task_);
}

TEST_F(EditingTest, SnapshotsAreShownAndCompared) {
  command({{"do", "snapshot"}, {"name", "as built"}});
  command({{"do", "edit"}, {"values", {{kThigh, 0.07}}}});
  const Json table = browser_.get("/api/compare?a=as%20built&b=");
  EXPECT_EQ(table["rows"][0]["a"], 0.06);
  EXPECT_EQ(table["rows"][0]["b"], 0.07);
  const Json shown = browser_.get("/api/shown?name=as%20built&task=0");
  EXPECT_EQ(shown["design"]["bodies"].size(), shown["motion"]["bodies"].get<std::size_t>());
  EXPECT_EQ(browser_.get("/api/shown?name=nobody")["status"], 400);
  const std::string ghost = "/api/design?values=%7B%22front_thigh_length%22%3A0.09%7D";
  EXPECT_EQ(browser_.get(ghost)["handles"][0][0], Json::array({0.0, 0.0, -0.09}));
  EXPECT_EQ(value(browser_.settled()), 0.07) << "a ghost changes nothing";
}

TEST_F(EditingTest, ASavedSessionIsTakenUpFromItsRun) {
  command({{"do", "edit"}, {"values", {{kThigh, 0.066}}}});
  (void)browser_.settled();
  EXPECT_EQ(browser_.post("/api/save", {{"path", "runs/mine"}})["status"], 200);
  EXPECT_EQ(browser_.post("/api/save", {{"path", "runs/mine"}})["status"], 409) << "is there";
  EXPECT_EQ(browser_.post("/api/save", {{"path", "runs/it"}, {"force", "yes"}})["status"], 400);
  command({{"do", "edit"}, {"values", {{kThigh, 0.05}}}});
  EXPECT_EQ(browser_.post("/api/open", {{"path", "runs/mine"}})["status"], 200);
  const Json state = browser_.settled();
  EXPECT_EQ(value(state), 0.066);
  EXPECT_TRUE(state["can_undo"].get<bool>());
  const Json start = browser_.get("/api/start");
  EXPECT_EQ(start["recent"][0]["path"], (studio_.folder.path() / "runs/mine").string());
  EXPECT_EQ(start["recent"][0]["words"], "puppy, run mine");
  EXPECT_EQ(start["recent"][0]["opened"].get<std::string>().size(), 16U);
  EXPECT_EQ(start["recent"][1]["words"], "puppy, sideways");
  EXPECT_EQ(start["unsaved"][0]["name"], "puppy, sideways");
  const auto recent = studio_.folder.path() / "state/recent.json";
  ASSERT_TRUE(std::filesystem::is_regular_file(recent)) << recent;
  Json edited = Json::parse(read_file(recent));
  edited[0]["words"] = 7;
  write_file(recent, to_text(edited));
  EXPECT_EQ(browser_.get("/api/start")["recent"][0]["words"], "") << "somebody's edit";
  EXPECT_EQ(browser_.get("/api/free?path=runs/mine")["path"], "runs/mine_2");
  EXPECT_EQ(browser_.get("/api/free?path=runs/mine/")["path"], "runs/mine_2") << "beside, not in";
  EXPECT_EQ(browser_.get("/api/free?path=runs/other")["path"], "runs/other");
  EXPECT_EQ(browser_.get("/api/free?path=/etc/mine")["status"], 400);
  ASSERT_EQ(start["unsaved"].size(), 1U) << "what came after it was saved is kept";
  EXPECT_EQ(start["unsaved"][0]["origin"], task_);
}

TEST_F(EditingTest, TheBodiesAtTheBoundsOfAParameterAreToldAndChangeNothing) {
  (void)browser_.settled();
  command({{"do", "bounds"}, {"name", kThigh}, {"lower", 0.05}, {"upper", 0.08}});
  const std::string path = std::string("/api/bounds?task=0&name=") + kThigh;
  const Json found = browser_.get(path);
  EXPECT_EQ(found["lower"]["value"], 0.05);
  EXPECT_EQ(found["upper"]["value"], 0.08);
  const Json motion = browser_.get("/api/motion?task=0");
  for (const char* side : {"lower", "upper"}) {
    EXPECT_EQ(found[side]["motion"]["frames"], motion["frames"]);
    EXPECT_EQ(found[side]["design"]["bodies"].size(), motion["bodies"].get<std::size_t>());
    EXPECT_NE(found[side]["motion"]["poses"], motion["poses"]) << "another body";
  }
  EXPECT_EQ(value(browser_.settled()), 0.06);
  EXPECT_EQ(browser_.get("/api/bounds?name=tail")["status"], 400);
  EXPECT_EQ(browser_.get("/api/bounds")["status"], 400);
  EXPECT_EQ(browser_.get(path + "0")["status"], 400) << "no such parameter";
  EXPECT_EQ(browser_.get(std::string("/api/bounds?task=1&name=") + kThigh)["status"], 400);
}

TEST_F(EditingTest, FewestChangesAreWorkedOutAndOneIsChosenAndUndone) {
  command({{"do", "edit"}, {"values", {{kThigh, 0.066}, {"body_length", 0.2}}}});
  (void)browser_.settled();
  ASSERT_EQ(command({{"do", "work_out"}, {"what", "fewest"}})["status"], 200);
  const Json found = browser_.next("alternatives");
  ASSERT_FALSE(found.is_null());
  EXPECT_EQ(found["what"], "fewest");
  ASSERT_FALSE(found["designs"].empty());
  EXPECT_EQ(found["worths"].size(), 2U);
  const Json state = browser_.settled();
  EXPECT_EQ(state["alternatives"], Json::array({"fewest"}));
  const int last = static_cast<int>(found["designs"].size()) - 1;
  const Json choose{{"do", "choose"}, {"what", "fewest"}, {"design", last}};
  ASSERT_EQ(command(choose)["status"], 200);
  EXPECT_EQ(browser_.settled()["s"], found["designs"].back()["s"]);
  ASSERT_EQ(command({{"do", "undo"}})["status"], 200);
  EXPECT_EQ(value(browser_.settled()), 0.066);
  Browser second(studio_.server->url());
  EXPECT_EQ(second.next("alternatives")["what"], "fewest") << "a page that comes later knows them";
}

TEST_F(EditingTest, WhatCannotBeWorkedOutOrChosenIsRefused) {
  (void)browser_.settled();
  EXPECT_EQ(command({{"do", "work_out"}, {"what", "best"}})["status"], 400);
  EXPECT_EQ(command({{"do", "work_out"}})["status"], 400);
  EXPECT_EQ(command({{"do", "worked_out"}, {"what", "fewest"}})["status"], 400);
  EXPECT_EQ(command({{"do", "choose"}, {"what", "fewest"}, {"design", 0}})["status"], 400);
  EXPECT_EQ(command({{"do", "choose"}, {"what", "fewest"}, {"design", -1}})["status"], 400);
  for (const char* what : {"front", "fewest"}) {
    const Json refused = command({{"do", "work_out"}, {"what", what}});
    EXPECT_EQ(refused["status"], 400);
    EXPECT_EQ(refused["error"]["where"], what) << "one task, and a body as it was given";
  }
}

TEST_F(EditingTest, ASlopeAndAStepAreToldWithTheMotion) {
  (void)browser_.settled();
  EXPECT_EQ(browser_.get("/api/motion?task=0")["up"], Json::array({0.0, 0.0, 1.0}));
  browser_.post("/api/task", {{"changes",
                               {{"travel", {{"velocity", {0.05, 0.0}}}},
                                {"ground", {{"slope_along", 0.1}}},
                                {"limits", {{"step_over", 0.005}, {"swing_height", 0.02}}}}}});
  const Json motion = browser_.get("/api/motion?task=0");
  EXPECT_NEAR(motion["up"][0].get<double>(), std::sin(0.1), 1e-9) << "uphill, up leans ahead";
  EXPECT_EQ(motion["step"], 0.005);
}

TEST_F(EditingTest, PhysicsPlayTheGaitAndAPushIsFelt) {
  browser_.post("/api/task", {{"changes", {{"travel", {{"velocity", {0.05, 0.0}}}}}}});
  (void)browser_.settled();
  EXPECT_EQ(browser_.post("/api/physics", {{"run", true}})["status"], 200);
  const Json walking =
      browser_.next("physics", [](const Json& p) { return p["time"].get<double>() > 0.5; });
  ASSERT_FALSE(walking.is_null());
  EXPECT_EQ(walking["fell"], nullptr);
  double carried = 0.0;
  for (const Json& foot : walking["feet"]) carried += foot["force"][2].get<double>();
  EXPECT_NEAR(carried, 23.3, 12.0) << "its feet carry the puppy";
  EXPECT_NEAR(walking["speed"].get<double>(), 1.0, 0.8);
  const Json push{{"body", 1}, {"force", {0.0, 60.0, 30.0}}, {"point", {0.0, 0.0, 0.0}}};
  browser_.post("/api/physics", {{"push", push}});
  const Json fallen = browser_.next("physics", [](const Json& p) { return !p["fell"].is_null(); });
  EXPECT_FALSE(fallen["fell"]["words"].get<std::string>().empty());
  browser_.post("/api/physics", {{"push", nullptr}, {"reset", true}});
  EXPECT_FALSE(
      browser_.next("physics", [](const Json& p) { return p["fell"].is_null(); }).is_null());
  browser_.post("/api/physics", {{"run", false}});
  EXPECT_FALSE(browser_.next("physics", [](const Json& p) { return !p["running"]; }).is_null());
  EXPECT_EQ(browser_.post("/api/physics", {{"gains", {0.0, 1.0}}})["status"], 400);
  EXPECT_EQ(browser_.post("/api/physics", {{"friction", -1.0}})["status"], 400);
}

TEST(OpeningTest, ExamplesHavePicturesAndOpenByName) {
  OpenStudio studio;
  const Json start = studio.browser->get("/api/start");
  ASSERT_GT(start["examples"].size(), 10U);
  const Json drawn = studio.browser->get("/api/example?name=hexapod/wave");
  EXPECT_EQ(from_base64(drawn["poses"].get<std::string>())->size(), drawn["bodies"].size() * 28);
  EXPECT_EQ(studio.browser->post("/api/open", {{"example", "quadruped/both"}})["status"], 200);
  EXPECT_EQ(studio.browser->get("/api/document")["tasks"].size(), 2U);
}

}  // namespace
}  // namespace legwright
