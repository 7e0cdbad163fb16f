// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/report/html.hpp"
#include "tools/report/pair_report.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Two copies of the fixture, of which the second has another body and other margins.
class PairTest : public RunFixture {
 protected:
  void SetUp() override {
    RunFixture::SetUp();
    other_ = fs::path(run_.string() + "_b");
    fs::remove_all(other_);
    copy_fixture(other_);
    edit("../" + other_.filename().string() + "/run.json", [](Json& run) {
      run["task"]["gait"] = "trot";
      run["parameters"][0]["final"] = 1.0;
      run["parameters"][1]["name"] = "tail_length";
    });
    edit("../" + other_.filename().string() + "/result/robustness.json",
         [](Json& file) { file["factors"][1]["high"] = 1.25; });
    edit("../" + other_.filename().string() + "/result/verdict.json",
         [](Json& file) { file["result"]["limits"][2]["pass"] = false; });
  }
  void TearDown() override {
    fs::remove_all(other_);
    RunFixture::TearDown();
  }
  std::string pair() { return pair_page(read_pair(run_, other_)); }

  fs::path other_;
};

/// Of A the planned strip stands in.
TEST_F(PairTest, LeavesOutAPictureOfAnotherResultAndSaysSo) {
  add_pictures();
  write_png(run_ / "result" / "strip_physics.png", Image(32, 48, {1, 2, 3}),
            R"({"inputs/task.toml":"0"})");
  const std::string page = pair();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "A: result/strip_physics.png is not of this result: render again"));
  EXPECT_FALSE(has(page, "B: result/"));
  EXPECT_TRUE(has(page, "data:image/png"));
}

TEST_F(PairTest, ShowsBothAndWhatDiffers) {
  add_pictures();
  write_png(other_ / "result" / "strip_physics.png", Image(32, 48, {1, 2, 3}));
  const std::string page = pair();
  expect_well_formed(page);
  for (const char* part :
       {"A · fixture-puppy · sideways", "B · fixture-puppy · sideways", "task gait",
        "data-label=\"B\">trot</td>", "tail length", "not free", "1000.0 mm",
        "survives from 0.5 or less to 1.25", "survives from 0.5 or less to 1.62", "B less A",
        "Cost F by design iteration", "187 of 200 draws survived", "width: 50.00%"})
    EXPECT_TRUE(has(page, part)) << part;
  EXPECT_FALSE(has(page, "href="));
  EXPECT_LT(page.size(), 5'000'000U);
  EXPECT_EQ(page, pair());
  const auto failing = page.find("turned away from the wanted heading");
  EXPECT_LT(failing, page.find("measured over planned speed")) << "what one of them fails is first";
}

TEST_F(PairTest, OfOneRunTwiceNothingDiffers) {
  const std::string page = pair_page(read_pair(run_, run_));
  EXPECT_TRUE(has(page, "the same task and the same settings for both"));
  EXPECT_FALSE(has(page, "not free"));
  EXPECT_FALSE(has(page, "data-label=\"B less A\">+"));
}

TEST_F(PairTest, SaysWhatIsMissing) {
  for (const fs::path& run : {run_, other_}) {
    fs::remove_all(run / "result");
    fs::remove_all(run / "iterations");
    fs::remove(run / "events.jsonl");
  }
  const std::string page = pair();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "legwright validate " + run_.generic_string()));
  EXPECT_TRUE(has(page, "legwright render " + other_.generic_string()));
  write_file(other_ / "run.json", R"({"schema": "legwright/run", "version": 1})");
  EXPECT_TRUE(has(refusal_of(other_), "run.json: status: expected a value"));
  EXPECT_THROW(pair(), IoError);
  EXPECT_THROW(read_pair(run_, run_ / "nothing"), IoError);
}

TEST_F(PairTest, SaysWhoseFIsOfTheGaitBeforePhysicsSteps) {
  const std::string words = ": F is of the gait";
  EXPECT_FALSE(has(pair(), words));
  edit_run([](Json& run) { run["physics_steps"] = physics_steps(true); });
  EXPECT_TRUE(has(pair(), "A" + words));
  EXPECT_FALSE(has(pair(), "B" + words));
}

TEST_F(PairTest, TellsWhatFailsUndisturbedFromWhatWasNotVariedYet) {
  const std::string not_yet = "othing was varied yet", fails = "the gait fails undisturbed: fell.";
  const auto fail = [&](const fs::path& run) {
    edit("../" + run.filename().string() + "/result/robustness.json", [](Json& file) {
      file["undisturbed_cause"] = "fell";
      file["factors"] = Json::array();
      file["monte_carlo"]["samples"] = file["monte_carlo"]["survived"] = 0;
    });
  };
  fail(other_);
  EXPECT_TRUE(has(pair(), "B: No margins: " + fails));
  EXPECT_TRUE(has(pair(), "survives up to 13 ms")) << "of A";
  fail(run_);
  EXPECT_TRUE(has(pair(), "A: No margins: " + fails));
  EXPECT_FALSE(has(pair(), not_yet));
  fs::remove(run_ / "result" / "robustness.json");
  EXPECT_TRUE(has(pair(), "A: n" + not_yet));
  EXPECT_TRUE(has(pair(), "B: No margins: " + fails));
  fs::remove(other_ / "result" / "robustness.json");
  EXPECT_TRUE(has(pair(), "N" + not_yet + " in either run"));
}

TEST_F(PairTest, RefusesJointRunsAndNamesTheirTasks) {
  edit_run([](Json& run) {
    run["status"] = "running";
    for (const char* name : {"pace", "sideways"}) {
      run["task"]["name"] = name;
      run["task"]["folder"] = std::string("tasks/") + name;
      run["tasks"].push_back(run["task"]);
    }
    run.erase("task");
  });
  try {
    read_pair(other_, run_);
    FAIL() << "a joint run is no run of one task";
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(), (run_ / "tasks/pace").generic_string())) << error.what();
    EXPECT_TRUE(has(error.what(), (run_ / "tasks/sideways").generic_string()));
  }
}

TEST_F(PairTest, HasAFileOfItsOwn) {
  EXPECT_EQ(pair_file("runs/a", "runs/b/"), fs::path("runs/a/compare_b.html"));
  EXPECT_EQ(pair_file("runs/a", "runs/b c\"<"), fs::path("runs/a/compare_b_c__.html"));
  EXPECT_EQ(pair_file("a", "/"), fs::path("a/compare_other.html"));
}

TEST_F(PairTest, StaysSmallWhateverThePictures) {
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x10\0\0\0\0\x10", 24);
  for (const fs::path& run : {run_, other_})
    write_file(run / "result" / "strip_physics.png", head + std::string(2'500'000, 'x'));
  const std::string page = pair();
  EXPECT_LT(page.size(), 5'000'000U);
  EXPECT_TRUE(has(page, "data:image/png"));
}

TEST_F(PairTest, SurvivesJudgementsOfWrongTypes) {
  for (const char* file : {"verdict", "metrics", "comparison", "robustness", "numerics"})
    write_file(run_ / "result" / (std::string(file) + ".json"), "[1]");
  expect_well_formed(pair());
}

TEST_F(PairTest, HostileNamesStayText) {
  const auto name_all = [&](const std::string& name) {
    edit_run([&](Json& run) {
      run["robot"] = run["task"]["name"] = run["task"]["gait"] = name;
      run["parameters"][0]["name"] = run["sha256"]["task.toml"] = name;
    });
    edit("result/robustness.json", [&](Json& file) {
      for (const char* key : {"name", "label", "unit", "low_cause"}) file["factors"][0][key] = name;
    });
    edit("result/verdict.json", [&](Json& file) {
      for (const char* key : {"name", "what", "unit", "where"})
        file["result"]["limits"][0][key] = name;
      file["result"]["line"] = file["result"]["reasons"][0] = name;
    });
  };
  name_all("plain");
  const std::size_t expected = tags_of(pair());
  for (const std::string& raw : hostile_names()) {
    const std::string name = clean_utf8(raw);
    name_all(name);
    const std::string page = pair();
    expect_well_formed(page);
    EXPECT_EQ(tags_of(page), expected) << name;
  }
}

}  // namespace
}  // namespace legwright
