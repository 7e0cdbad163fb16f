// SPDX-License-Identifier: Apache-2.0
// The sections that tell what physics said: limits, plan against physics, robustness, numerics.
#include <gtest/gtest.h>

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kComparison = "result/comparison.json";
constexpr const char* kRobustness = "result/robustness.json";
constexpr const char* kNumerics = "result/numerics.json";
constexpr const char* kDrake = "result/validation_drake.json";
constexpr const char* kVerdict = "result/verdict.json";

class JudgedSections : public RunFixture {
 protected:
  /// Whether reading leaves such a note.
  bool has_note(const std::string& part) const {
    for (const std::string& note : read_run(run_).notes)
      if (note.find(part) != std::string::npos) return true;
    return false;
  }
};

TEST_F(JudgedSections, TellWhatTheFilesHold) {
  const std::string page = this->page();
  expect_well_formed(page);
  for (const char* part : {"All 6 limits are kept.",
                           "1 of 3 limits are kept.",
                           "95.0 % … 105.0 %",
                           "not measured",
                           "at most 20.1°",
                           "Contact forces, foot by foot",
                           "4.2 ms early",
                           "at worst off by 11 ms",
                           "Path of the robot from above",
                           "Height of the centre of mass",
                           "FL hip · 0.663 of 2.5 N·m",
                           "survives from 0.33 to 1.6 or more",
                           "survives up to 13 ms",
                           "survives from −17.8° to 16°",
                           "Above: falls after 2.31 s",
                           "9 × tilted",
                           "draw 12: ",
                           "0.5 ms",
                           "−0.3 %",
                           "All agree: "})
    EXPECT_TRUE(has(page, part)) << part;
  EXPECT_TRUE(in_order(page, {"Is the plan sound?", "2.1 % of the weight", "0.45 of friction",
                              "0.8 (", "3.02 N", "6.2 %", "HR"}));
  EXPECT_TRUE(in_order(page, {"187 of 200", "93.5 %", "89.2 % … 96.2 %"}));
  EXPECT_FALSE(has(page, "Could not be used"));
}

TEST_F(JudgedSections, TellOfTheSecondEngineWhereItPlayed) {
  const std::string words =
      "Drake 1.51.1 passes at half and default gains and fails at double gains, at 63.2 % … 98.4 % "
      "of the planned speed. It tilts by 0.620 at double gains (less than 5.7° (0.1 rad) passes).";
  std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(in_order(page, {words.c_str(), "✓", "Drake 1.51.1, half gains", "98.1 %", "same", "✗",
                              "Drake 1.51.1, double gains", "63.2 %", "from MuJoCo’s"}));
  EXPECT_TRUE(has(report_summary(read_run(run_)), "**Second engine.** Drake 1.51.1 passes at"));
  edit(kDrake, [](Json& file) {
    file["passes"]["double"] = file["verdict"]["pass"] = true;
    file["verdict"]["reasons"] = Json::array();
    file["result"]["double"]["speed_ratio"] = 0.979;
    file["result"]["half"]["turn_ratio"] = 0.99;
  });
  page = this->page();
  EXPECT_TRUE(
      has(page,
          "Drake 1.51.1 passes at half, default and double gains, at 97.9 % … 98.4 % of the "
          "planned speed and 99.0 % … 99.0 % of the planned turn rate.</p>"));
  fs::remove(run_ / kDrake);
  EXPECT_FALSE(has(this->page(), "Drake"));
  EXPECT_FALSE(has(report_summary(read_run(run_)), "Second engine"));
}

TEST_F(JudgedSections, AVerdictOfAnotherResultIsNotShown) {
  EXPECT_TRUE(has(page(), "✓ Pass"));
  EXPECT_TRUE(has(page(), "without sums: an older Legwright judged"));
  const auto of = json_of(sums_of_run(run_));
  for (const char* file : {kVerdict, kRobustness, kNumerics})
    edit(file, [&](Json& document) { document["of"] = of; });
  EXPECT_TRUE(has(page(), "✓ Pass"));
  EXPECT_FALSE(has(page(), "without sums"));
  const fs::path motion = run_ / "result" / "motion.csv";
  write_file(motion, read_file(motion) + "\n");
  const std::string page = this->page();
  expect_well_formed(page);
  for (const char* shown : {"✓ Pass", "limits are kept", "187 of 200", "All agree: "})
    EXPECT_FALSE(has(page, shown)) << shown;
  EXPECT_TRUE(has(page, "No verdict: result/verdict.json is not of this result: judge again."));
  for (const char* file : {"verdict.json", "robustness.json", "numerics.json"})
    EXPECT_TRUE(has_note(std::string(file) + ": not of this result: judge again")) << file;
  const std::string summary = report_summary(read_run(run_));
  EXPECT_FALSE(has(summary, "PASS"));
  EXPECT_TRUE(has(summary, "not of this result: judge again"));
}

TEST_F(JudgedSections, AFileOfAnotherJudgementThanTheVerdictIsNotShown) {
  Json with;
  for (const char* file : {"metrics.json", "comparison.json", "numerics.json", "robustness.json"})
    with[file] = sha256_hex(read_file(run_ / "result" / file));
  edit(kVerdict, [&](Json& document) { document["with"] = with; });
  EXPECT_TRUE(read_run(run_).notes.empty());
  EXPECT_TRUE(has(page(), "187 of 200"));
  edit(kRobustness, [](Json& file) { file["seed"] = 7; });
  edit(kVerdict, [](Json& document) { document["with"].erase("numerics.json"); });
  const std::string page = this->page();
  EXPECT_TRUE(has(page, "✓ Pass"));
  EXPECT_FALSE(has(page, "187 of 200"));
  EXPECT_FALSE(has(page, "All agree: "));
  for (const char* file : {"robustness.json", "numerics.json"})
    EXPECT_TRUE(has_note(std::string(file) + ": not of the verdict beside it: judge again"));
}

TEST_F(JudgedSections, FailingLimitsComeFirst) {
  edit(kVerdict, [](Json& verdict) { verdict["result"]["limits"][3]["pass"] = false; });
  const std::string page = this->page();
  const auto slip = page.find("slip per stance, mean"), speed = page.find("measured over planned");
  ASSERT_NE(slip, std::string::npos);
  EXPECT_LT(slip, speed);
  EXPECT_TRUE(has(page, "5 of 6 limits are kept."));
}

TEST_F(JudgedSections, StrictBoundsAreToldAsSuch) {
  EXPECT_FALSE(has(page(), "less than 20.1°"));
  edit(kVerdict, [](Json& verdict) {
    for (Json& row : verdict["result"]["limits"]) row["strict"] = true;
  });
  EXPECT_TRUE(has(page(), "less than 20.1°"));
  EXPECT_TRUE(has(page(), "strictly within 95.0 % … 105.0 %"));
  edit(kVerdict, [](Json& verdict) { verdict["result"]["limits"][1].erase("strict"); });
  EXPECT_TRUE(has(page(), "at most 20.1°"));
  edit(kVerdict, [](Json& verdict) { verdict["result"]["limits"][1]["strict"] = "yes"; });
  EXPECT_TRUE(has_note("verdict.json: result.limits[1].strict: expected true or false"));
}

TEST_F(JudgedSections, AGaitThatFellHasNoMeanCycle) {
  edit(kComparison, [](Json& file) { file["result"] = nullptr; });
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "fell before two cycles were complete"));
  EXPECT_FALSE(has(page, "Contact forces, foot by foot"));
}

TEST_F(JudgedSections, AGaitThatFailsUndisturbedHasNoMargins) {
  edit(kRobustness, [](Json& file) {
    file["undisturbed_cause"] = "falls after 2.87 s";
    file["factors"] = Json::array();
    file["monte_carlo"]["samples"] = file["monte_carlo"]["survived"] = 0;
  });
  for (const std::string& text : {page(), report_summary(read_run(run_))}) {
    EXPECT_TRUE(has(text, "the gait fails undisturbed: falls after 2.87 s."));
    EXPECT_FALSE(has(text, "0 of 0"));
  }
}

/// Only the end of what was tried fails: the margin is no finding of its own.
TEST_F(JudgedSections, AMarginThatEndsWithTheRangeSaysSo) {
  edit(kRobustness, [](Json& file) {
    file["factors"][0]["low"] = 0.115;
    file["factors"][0]["low_fails"] = 0.1;
  });
  EXPECT_TRUE(has(page(), "survives from 0.115 (all tried but 0.1) to 1.6 or more"));
  edit(kRobustness, [](Json& file) { file["factors"][0]["low_fails"] = 0.11; });  // twin
  EXPECT_TRUE(has(page(), "survives from 0.115 to 1.6 or more"));
}

TEST_F(JudgedSections, AChartWithoutAUnitHasNoCommaInItsPlace) {
  const std::string page = this->page();
  EXPECT_TRUE(has(page, ">N, over the share of the cycle<"));  // twin: with a unit
  EXPECT_TRUE(has(page, ">over the share of the cycle<"));
  EXPECT_FALSE(has(page, ">, over"));
  EXPECT_FALSE(has(page, " , over"));
}

TEST_F(JudgedSections, ABodyThatTouchesItselfIsWarnedOf) {
  EXPECT_FALSE(has(page(), "Warning"));
  edit(kVerdict, [](Json& file) {
    file["home_touches"] = {{"line", "geom '<b>knee</b>' and 'x' touch"}, {"pairs", Json::array()}};
  });
  EXPECT_TRUE(has(page(), "Warning: geom '&lt;b&gt;knee&lt;/b&gt;' and 'x' touch."));
  EXPECT_TRUE(has(report_summary(read_run(run_)), "**Warning.** geom "));
  edit(kVerdict, [](Json& file) { file["home_touches"] = 3; });
  EXPECT_FALSE(has(page(), "Warning"));
  EXPECT_TRUE(has_note("verdict.json: home_touches: expected an object, found 3"));
  expect_well_formed(page());
}

TEST_F(JudgedSections, OptionsThatScenesSetOtherwiseAreTold) {
  EXPECT_FALSE(has(page(), "In MuJoCo scenes have"));
  edit(kVerdict, [](Json& file) {
    const Json option{{"name", "iterations"}, {"file", "1"}, {"scene", "100"}};
    file["overridden"] = {
        {"line", "scenes have options of their own: iterations 100 (its file has 1)"},
        {"options", Json::array({option})}};
  });
  EXPECT_TRUE(has(page(), "In MuJoCo scenes have options of their own: iterations 100 (its file"));
  expect_well_formed(page());
}

TEST_F(JudgedSections, DrawEachFootAndTheInitialBodyToo) {
  edit(kComparison, [](Json& file) { file["initial"] = file["result"]; });
  EXPECT_TRUE(has(page(), "Contact forces before, with the initial body"));
  EXPECT_EQ(count_of(page(), "aria-label=\"Normal force, FL\""), 2U);
}

TEST_F(JudgedSections, NumbersThatAreNotThereBreakLinesAndNothingElse) {
  edit(kComparison, [](Json& file) {
    for (const char* curve : {"mean", "low", "high"})
      file["result"]["feet"][0]["force_normal_N"][curve][3] = nullptr;
    file["result"]["curves"][0]["planned"] = nullptr;
    for (auto& [key, value] : file["result"]["inverse_dynamics"].items())
      if (value.is_number()) value = nullptr;
  });
  edit(kRobustness, [](Json& file) {
    file["factors"][0]["nominal"] = nullptr;
    file["monte_carlo"]["share_low"] = nullptr;
  });
  edit(kNumerics, [](Json& file) { file["runs"][1]["speed_ratio"] = nullptr; });
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_FALSE(has(page, "nan"));
  EXPECT_TRUE(has(page, "187 of 200 draws survived: 93.5 %.")) << "without an interval";
}

TEST_F(JudgedSections, LeaveOutWhatHasAnotherFormWithANoteOfTheKey) {
  const auto note_of = [&](const char* file, const std::function<void(Json&)>& change) {
    const Json whole = read_json(run_ / file);
    edit(file, change);
    const std::string page = this->page();
    expect_well_formed(page);
    EXPECT_TRUE(has(page, "Could not be used"));
    const auto notes = read_run(run_).notes;
    write_json(run_ / file, whole, Durability::process);
    return notes.size() == 1 ? notes[0].substr(notes[0].find(file)) : "";
  };
  const auto starts = [](const std::string& note, const std::string& part) {
    EXPECT_TRUE(note.starts_with(part)) << note;
  };
  starts(note_of(kComparison,
                 [](Json& file) {
                   file["result"]["feet"][0]["force_normal_N"]["mean"] = {1, 2, 3};
                 }),
         "result/comparison.json: feet: FL.mean: expected 12 numbers as in phases, found 3");
  starts(note_of(kComparison, [](Json& file) { file["result"]["curves"] = "x"; }),
         "result/comparison.json: result.curves: expected a list");
  starts(note_of(kComparison,
                 [](Json& file) {
                   file["result"]["joints"] = Json::array({1, nullptr, "x"});
                 }),
         "result/comparison.json: result.joints[0]: expected an object");
  starts(note_of(kComparison,
                 [](Json& file) {
                   file["result"]["path_xy"]["measured"] = {{"a", 1}};
                 }),
         "result/comparison.json: result.path_xy.measured: expected a list");
  starts(note_of(kRobustness, [](Json& file) { file["factors"][0]["tested_low"] = "x"; }),
         "result/robustness.json: factors[0].tested_low: expected a number");
  starts(note_of(kRobustness,
                 [](Json& file) {
                   file["monte_carlo"] = {1, 2};
                 }),
         "result/robustness.json: monte_carlo: expected an object");
  starts(note_of(kVerdict, [](Json& file) { file["result"]["limits"][0]["pass"] = "yes"; }),
         "result/verdict.json: result.limits[0].pass: expected true or false");
  starts(note_of(kVerdict, [](Json& file) { file["result"]["limits"][0]["wish"] = 1; }),
         "result/verdict.json: result.limits[0].wish: expected no such key, found 1");
  starts(note_of(kNumerics, [](Json& file) { file["runs"][1].erase("label"); }),
         "result/numerics.json: runs[1].label: expected a value, found no such key");
  starts(note_of("result/metrics.json",
                 [](Json& file) { file["result"]["half"]["feet"][0]["contacts_s"] = {{1}}; }),
         "result/metrics.json: result.half.feet[0].contacts_s[0]: expected a list of 2");
}

TEST_F(JudgedSections, SurviveFilesOfWrongTypes) {
  for (const char* file : {kComparison, kRobustness, kNumerics, kDrake}) {
    edit(file, [](Json& document) {
      for (auto& [key, value] : document.items())
        if (key != "schema" && key != "version")
          value = Json::array({"x", 1, nullptr, {{"a", 1}, {"phases", {1, 2}}}});
    });
  }
  edit(kVerdict, [](Json& document) { document["result"] = Json::array({1}); });
  expect_well_formed(page());
  EXPECT_NO_THROW(report_summary(read_run(run_)));
  for (const char* file : {kComparison, kRobustness, kNumerics}) {
    write_file(run_ / file, R"({"schema": "other/thing", "version": 1})");
  }
  for (const char* file : {kComparison, kRobustness, kNumerics})
    EXPECT_TRUE(has_note(std::string(file) + ": the file: expected \"schema\": \"legwright/"));
  for (const char* file : {kComparison, kRobustness, kNumerics}) write_file(run_ / file, "{\"a\":");
  expect_well_formed(page());
}

TEST_F(JudgedSections, HugeListsAreCutAndThePageStaysSmall) {
  edit(kComparison, [](Json& file) {
    Json& result = file["result"];
    const Json foot = result["feet"][0], joint = result["joints"][0], curve = result["curves"][0];
    for (int k = 0; k < 300; ++k) {
      result["feet"].push_back(foot);
      result["joints"].push_back(joint);
      result["curves"].push_back(curve);
      result["cycle_table"].push_back(result["cycle_table"][0]);
    }
    for (int k = 0; k < 20'000; ++k) result["path_xy"]["measured"].push_back({0.001 * k, 0.5});
  });
  edit(kRobustness, [](Json& file) {
    for (int k = 0; k < 2000; ++k) {
      file["factors"].push_back(file["factors"][0]);
      file["monte_carlo"]["causes"][std::to_string(k)] = k;
      file["monte_carlo"]["worst"].push_back(file["monte_carlo"]["worst"][0]);
    }
  });
  edit(kNumerics, [](Json& file) {
    for (int k = 0; k < 2000; ++k) file["runs"].push_back(file["runs"][0]);
  });
  edit(kVerdict, [](Json& file) {
    for (int k = 0; k < 2000; ++k) file["result"]["limits"].push_back(file["result"]["limits"][0]);
  });
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_LT(page.size(), 2'000'000U);
  EXPECT_TRUE(has(page, "all but the first 16 of 304 entries of \"feet\""));
  const std::vector<double> many(5000, 0.5);
  edit(kComparison, [&](Json& file) {
    Json& result = file["result"];
    result["phases"] = result["inverse_dynamics"]["residual_force_share"] = many;
    for (const char* list : {"curves", "feet", "joints"}) result[list] = Json::array();
  });
  EXPECT_TRUE(has(this->page(), "\"phases\" should hold 2 to 400 numbers"));
}

TEST_F(JudgedSections, HostileNamesStayText) {
  const auto name_all = [&](const std::string& name) {
    edit(kComparison, [&](Json& file) {
      file["initial"] = file["result"];
      for (const char* side : {"initial", "result"}) {
        for (const char* list : {"feet", "joints", "curves"})
          for (const char* key : {"name", "label", "unit"})
            if (Json& entry = file[side][list][0]; entry.contains(key)) entry[key] = name;
        for (const char* key : {"friction_worst_foot", "normal_force_min_foot"})
          file[side]["inverse_dynamics"][key] = name;
      }
    });
    edit(kRobustness, [&](Json& file) {
      for (const char* key : {"name", "label", "unit", "low_cause"}) file["factors"][0][key] = name;
      file["monte_carlo"]["spread"] = {{name, {0, 1}}};
      file["monte_carlo"]["causes"] = {{name, 3}};
      file["monte_carlo"]["worst"][0] = {
          {"sample", 1}, {"cause", name}, {"time_s", 1.0}, {"values", {{name, 1}}}};
    });
    edit(kNumerics, [&](Json& file) {
      for (const char* key : {"name", "label", "integrator", "cone", "line"})
        file["runs"][0][key] = name;
      file["agree"] = false;
      file["reasons"] = {name};
    });
    edit(kVerdict, [&](Json& file) {
      for (const char* side : {"initial", "result"}) {
        for (const char* key : {"name", "what", "unit", "where"})
          file[side]["limits"][0][key] = name;
        file[side]["limits"][0]["pass"] = false;
        file[side]["line"] = name;
      }
    });
  };
  name_all("plain");
  const std::size_t expected = tags_of(page());
  ASSERT_GE(hostile_names().size(), 40U);
  for (const std::string& raw : hostile_names()) {
    const std::string name = clean_utf8(raw);
    name_all(name);
    const std::string page = this->page();
    expect_well_formed(page);
    EXPECT_EQ(tags_of(page), expected) << name;
  }
}

}  // namespace
}  // namespace legwright
