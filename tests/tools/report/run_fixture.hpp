// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <filesystem>
#include <functional>
#include <string>

#include "tests/support/paths.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/image/png.hpp"
#include "tools/report/report.hpp"

namespace legwright {

/// A copy of the fixture run in a folder of its own.
class RunFixture : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    run_ = std::filesystem::path(testing::TempDir()) /
           (std::string("report_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(run_);
    copy_fixture(run_);
  }
  void TearDown() override { std::filesystem::remove_all(run_); }

  static void copy_fixture(const std::filesystem::path& folder) {
    std::filesystem::copy(std::filesystem::path(test::source_dir()) / "tests/tools/report/data",
                          folder, std::filesystem::copy_options::recursive);
  }
  void add_pictures() {
    const Image picture(64, 48, {200, 120, 40});
    write_png(run_ / "result" / "strip_physics.png", picture);
    write_png(run_ / "result" / "strip_before_after.png", picture);
    write_png(run_ / "iterations" / "0000" / "frame.png", picture);
  }
  std::string page() { return report_page(read_run(run_)); }
  /// @param file below the run's folder
  void edit(const std::string& file, const std::function<void(Json&)>& change) {
    Json document = read_json(run_ / file);
    change(document);
    write_json(run_ / file, document, Durability::process);
  }
  void edit_run(const std::function<void(Json&)>& change) { edit("run.json", change); }

  std::filesystem::path run_;
};

inline void expect_well_formed(const std::string& page) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(page.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
}

inline bool has(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

/// What reading a run says against it; empty where it is taken.
inline std::string refusal_of(const std::filesystem::path& run) {
  try {
    read_run(run);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

/// run.json's "physics_steps" of one step that was kept and one that was not.
inline Json physics_steps(bool changed) {
  const Json step{{"scalars", {{"speed", 1.01}}},
                  {"merit", 0.2},
                  {"predicted_merit", 0.1},
                  {"accepted", true},
                  {"line", "PASS  walk"}};
  Json rejected = step;
  rejected["accepted"] = false;
  return {{"before", {{"merit", 0.5}, {"pass", false}, {"line", "FAIL  walk: 93 % of it"}}},
          {"after", {{"merit", 0.1}, {"pass", true}, {"line", "PASS  walk: 100 % of it"}}},
          {"scalars", {{"speed", 1.012}, {"swing_height", 1.05}, {"margins", 1.0}}},
          {"factors", "speed x1.012"},
          {"period_s", 1.0},
          {"seconds", 3.5},
          {"changed", changed},
          {"rollouts", 9},
          {"steps", {step, rejected}}};
}

/// How many tags a page has: hostile text makes none more.
inline std::size_t tags_of(const std::string& page) {
  std::size_t count = 0;
  for (const char c : page) count += c == '<' ? 1 : 0;
  return count;
}

}  // namespace legwright
