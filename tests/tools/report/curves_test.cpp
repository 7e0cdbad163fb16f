// SPDX-License-Identifier: Apache-2.0
#include "tools/report/curves.hpp"
#include "tests/support/paths.hpp"
#include "tools/files/clean_text.hpp"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Makes run folders as `optimize` and `validate` leave them, with what curves read.
class CurvesTest : public testing::Test {
 protected:
  struct Run {
    double speed = 0.1;
    bool motion_only = false, pass = true, falls = false;
    double ratio = 1.0, touches = 0.0;
    std::string weights = "", robot = "aa", sentence = "both shins", leg = "cc";
    std::optional<double> optimum{};  // F of the optimum, where another design was handed back
  };
  fs::path make(const std::string& name, const Run& run) const {
    const fs::path root = folder_.path() / name;
    fs::create_directories(root / "inputs");
    fs::create_directories(root / "result");
    write_file(root / "inputs/task.toml",
               "robot = \"robot.xml\"\n[gait]\nname = \"tripod\"\nperiod = 0.6\n[travel]\n"
               "velocity = [0.1, 0.0]\n" +
                   run.weights);
    write_file(root / "inputs/robot.xml", "<mujoco/>");
    auto record = read_record_file<RunRecord>(fs::path(test::source_dir()) /
                                              "tests/tools/report/data/run.json");
    record.robot = "ant";
    record.motion_only = run.motion_only;
    record.task->gait = "tripod";
    record.task->velocity = {run.speed, 0.0};
    record.sha256 = {{"robot.xml", run.robot},
                     {"parts/leg.xml", run.leg},
                     {"task.toml", name},
                     {"inputs/task.toml", name}};
    record.final_F = 2.5;
    if (run.optimum) {
      CandidateRecord optimum;
      optimum.F = *run.optimum;
      record.choice.emplace().candidates = {optimum, CandidateRecord{}};
    }
    record.parameters = {
        {"shin_length", "m", "length", run.sentence, 0.1, 0.05, 0.2, 0.1 + run.speed / 10, 1}};
    write_json(root / "run.json", json_of(record));
    MetricsRecord metrics;
    for (const char* gain : kGains) {
      GainMetrics& measured = metrics.result.of(gain);
      if (run.falls) measured.fall = {1.5, "the trunk sank"};
      measured.speed_ratio = run.ratio;
      measured.tilt_max = 0.02;
      measured.self_contact.share = run.touches;
      measured.self_contact.count = run.touches > 0 ? 12 : 0;
    }
    write_json(root / "result/metrics.json", json_of(metrics));
    VerdictRecord verdict;
    verdict.result.pass = run.pass;
    if (!run.pass) verdict.result.reasons = {"slow"};
    write_json(root / "result/verdict.json", json_of(verdict));
    return root;
  }
  static std::string complaint(const std::vector<fs::path>& runs,
                               const std::vector<NamedRuns>& named = {}) {
    try {
      read_curves(runs, named);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  test::TemporaryFolder folder_;
};

TEST_F(CurvesTest, GroupsRunsByWhatTheyAreAndSortsThem) {
  const std::string off = "[weights]\nlimb_clearance = 0.0\nsmoothness = 0.1\npeak_torque = 0.0\n";
  const Curves curves = read_curves(
      {make("a", {.speed = 0.2}), make("b", {.speed = 0.1}), make("c", {.motion_only = true}),
       make("d", {.motion_only = true, .weights = off})},
      {});
  ASSERT_EQ(curves.variants.size(), 3U);
  EXPECT_EQ(curves.variants[0].name, "motion only, without limb clearance");
  EXPECT_EQ(curves.variants[1].name, "motion only");
  EXPECT_EQ(curves.variants[2].name, "co-designed");
  ASSERT_EQ(curves.variants[2].points.size(), 2U);
  EXPECT_EQ(curves.variants[2].points[0].wanted, 0.1);
  EXPECT_EQ(curves.way, "tripod forward");
}

TEST_F(CurvesTest, WhatFellHasNoSpeedButIsTold) {
  const Curves curves =
      read_curves({make("a", {.pass = false, .falls = true, .ratio = 0.9, .touches = 0.5})}, {});
  const CurvePoint& point = curves.variants[0].points[0];
  EXPECT_FALSE(point.at_default().speed);
  EXPECT_TRUE(point.falls());
  EXPECT_TRUE(point.touches());
  const Json json = curves_json(curves);
  EXPECT_TRUE(json["variants"][0]["passes_up_to_mps"].is_null());
  EXPECT_TRUE(json["variants"][0]["runs"][0]["gains"]["default"]["speed_mps"].is_null());
  EXPECT_EQ(json["variants"][0]["runs"][0]["gains"]["default"]["fall_time_s"], 1.5);
}

TEST_F(CurvesTest, PassesUpToEndsAtTheFirstFailure) {
  const Curves curves = read_curves(
      {make("a", {.speed = 0.1}), make("b", {.speed = 0.2, .pass = false, .ratio = 0.9}),
       make("c", {.speed = 0.3})},
      {});
  EXPECT_EQ(curves_json(curves)["variants"][0]["passes_up_to_mps"], 0.1);
  EXPECT_NEAR(*curves.variants[0].points[1].at_default().speed, 0.18, 1e-12);
}

TEST_F(CurvesTest, TheOptimumKeepsItsFWhereAnotherDesignIsHandedBack) {
  const Curves curves =
      read_curves({make("a", {.speed = 0.1}), make("b", {.speed = 0.2, .optimum = 1.5})}, {});
  const auto& points = curves.variants[0].points;
  EXPECT_EQ(points[0].optimum, 2.5);
  EXPECT_EQ(points[1].cost, 2.5);
  EXPECT_EQ(points[1].optimum, 1.5);
  EXPECT_EQ(curves_json(curves)["variants"][0]["runs"][1]["optimum_F"], 1.5);
}

TEST_F(CurvesTest, PictureHasADotWhereItPassesAndARingWhereItFails) {
  Curves curves = read_curves({make("a", {.speed = 0.1}), make("b", {.speed = 0.2, .pass = false}),
                               make("c", {.speed = 0.3, .pass = false})},
                              {});
  curves.variants[0].name = "<b> & \"co\"";
  const std::string picture = curves_picture(curves);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(picture.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  const auto count = [&](const std::string& what) {
    int found = 0;
    for (std::size_t at = 0; (at = picture.find(what, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("<circle class=\"f1\""), 1);
  EXPECT_EQ(count("<circle class=\"line c1\""), 2);
  EXPECT_NE(picture.find("&lt;b&gt; &amp;"), std::string::npos);
  EXPECT_EQ(curves_picture(Curves{}), "");
}

TEST_F(CurvesTest, RefusesWhatDoesNotBelongTogether) {
  const fs::path a = make("a", {});
  EXPECT_NE(complaint({a, make("b", {.robot = "bb"})}).find("another robot"), std::string::npos);
  EXPECT_NE(complaint({a, make("b2", {.speed = 0.2, .leg = "dd"})}).find("another robot"),
            std::string::npos);                               // an included file differs
  EXPECT_EQ(complaint({a, make("b3", {.speed = 0.2})}), "");  // only the task differs
  EXPECT_NE(complaint({a, make("c", {})}).find("--variant"), std::string::npos);
  EXPECT_EQ(complaint({a}, {{"other", {make("d", {})}}}), "");  // by another name they do
  EXPECT_NE(complaint({make("e", {.speed = -0.2}), a}).find("differ in speed alone"),
            std::string::npos);
  EXPECT_NE(complaint({make("f", {.speed = 0.0})}).find("task.velocity"), std::string::npos);
  fs::remove(a / "result/verdict.json");
  EXPECT_NE(complaint({a}).find("legwright validate " + a.generic_string()), std::string::npos);
}

TEST_F(CurvesTest, PageIsWellFormedSelfContainedAndTheSameEachTime) {
  const auto runs = {make("a", {.speed = 0.1}), make("b", {.speed = 0.2, .pass = false}),
                     make("c", {.motion_only = true, .pass = false, .falls = true})};
  for (const std::string& name : hostile_names()) {
    Curves curves = read_curves(runs, {});
    curves.robot = curves.variants[0].name = clean_utf8(name);
    curves.variants[1].points[0].reasons = {clean_utf8(name)};
    const std::string page = curves_page(curves);
    EXPECT_EQ(page, curves_page(curves));
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(page.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  }
  const std::string page = curves_page(read_curves(runs, {}));
  for (const char* reference : {"href=", "url(", "@import", "<link", "src="})
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  for (const char* part : {"PASS", "FAIL", "up to 0.1 m/s", "never passes", "shin length"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace legwright
