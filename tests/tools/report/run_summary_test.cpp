// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

using RunSummary = RunFixture;

constexpr std::ptrdiff_t kMostLines = 60;

std::ptrdiff_t lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

TEST_F(RunSummary, HoldsVerdictsLimitsMarginsAndChanges) {
  edit("result/verdict.json",
       [](Json& verdict) { verdict["result"]["limits"][3]["pass"] = false; });
  const std::string text = report_summary(read_run(run_));
  for (const char* part :
       {"| ❌ FAIL | falls after 1.29 s", "| ✅ PASS | 98 % of planned speed",
        "**Limits.** 5 of 6 limits are kept.", "| limit not kept | measured | allowed | worst at |",
        "| slip per stance, mean | 3.7 mm | at most 10 mm | double gains |",
        "| delay of the servos | survives up to 13 ms |", "187 of 200 draws survived",
        "| front hip axis roll (+10.5) | 0° | 80.2° |", "at upper bound"})
    EXPECT_TRUE(has(text, part)) << part << "\n" << text;
  EXPECT_LE(lines_of(text), kMostLines);
  EXPECT_FALSE(has(text, "\n\n\n"));
  EXPECT_EQ(text, report_summary(read_run(run_)));
}

TEST_F(RunSummary, StaysShortWhateverFails) {
  edit("result/verdict.json", [](Json& verdict) {
    Json& limits = verdict["result"]["limits"];
    for (Json& row : limits) row["pass"] = false;
    for (int k = 0; k < 80; ++k) limits.push_back(limits[0]);
    verdict["result"]["line"] = std::string(5000, 'x');
  });
  edit("result/robustness.json", [](Json& file) {
    for (int k = 0; k < 30; ++k) file["factors"].push_back(file["factors"][0]);
  });
  edit_run([](Json& run) {
    for (int k = 0; k < 50; ++k) run["parameters"].push_back(run["parameters"][0]);
  });
  const std::string text = report_summary(read_run(run_));
  EXPECT_LE(lines_of(text), kMostLines);
  EXPECT_LT(text.size(), 8000U);
  EXPECT_TRUE(has(text, "… and 80 more.")) << text;
}

TEST_F(RunSummary, SaysWhyAResultIsInfeasibleAndWhichWasPicked) {
  const std::string before = report_summary(read_run(run_));
  EXPECT_FALSE(has(before, "**Infeasible.**"));
  EXPECT_FALSE(has(before, "picked by hand"));
  edit_run([](Json& run) {
    run["feasible"] = false;
    run["reasons"] = {"joint hip needs 2 N m", "MuJoCo does not pass it"};
    run["picked"] = "iteration 3";
  });
  EXPECT_TRUE(in_order(report_summary(read_run(run_)),
                       {"Result picked by hand: iteration 3.", "**Infeasible.**",
                        "- joint hip needs 2 N m", "- MuJoCo does not pass it"}));
}

TEST_F(RunSummary, HostileNamesStayText) {
  for (const std::string& raw : hostile_names()) {
    const std::string name = clean_utf8(raw);
    edit_run([&](Json& run) { run["robot"] = run["parameters"][0]["name"] = name; });
    edit("result/verdict.json", [&](Json& file) {
      file["result"]["line"] = name;
      for (const char* key : {"what", "unit", "where"}) file["result"]["limits"][0][key] = name;
      file["result"]["limits"][0]["pass"] = false;
    });
    edit("result/robustness.json", [&](Json& file) { file["factors"][0]["label"] = name; });
    edit("result/numerics.json", [&](Json& file) { file["reasons"] = {name}; });
    edit("result/validation_drake.json", [&](Json& file) {
      file["engine"] = file["engine_version"] = name;
      file["verdict"]["reasons"] = {name};
    });
    const std::string text = report_summary(read_run(run_));
    EXPECT_FALSE(has(text, "<")) << name;
    EXPECT_EQ(count_of(text, "]("), count_of(text, "\\](")) << name;
    EXPECT_FALSE(has(text, "://")) << name;
    EXPECT_LE(lines_of(text), kMostLines) << name;
    std::size_t begin = 0;  // a row of a table has as many cells as its head, whatever is in it
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         begin = end + 1, end = text.find('\n', begin)) {
      if (text[begin] != '|') continue;
      std::size_t bars = 0;
      for (std::size_t k = begin; k < end; ++k)
        bars += text[k] == '|' && (k == begin || text[k - 1] != '\\') ? 1 : 0;
      EXPECT_GE(bars, 3U) << name;
      EXPECT_LE(bars, 5U) << name;
    }
  }
}

}  // namespace
}  // namespace legwright
