// SPDX-License-Identifier: Apache-2.0
// Every gait of the library for two, four and six feet has a task in the examples that passes at
// half, default and double gains, or fails for nothing but its heading. Tasks of other tests
// (sideways_test, turning_test, examples_test) are not run again. Five, seven and eight feet:
// own_robot_test.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "optimizer/motion/gait.hpp"
#include "tests/tools/verbs/judged_example.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

// Run by GaitExample below: what no other test runs.
constexpr const char* kTasks[] = {"quadruped/amble.toml",
                                  "quadruped/bound.toml",
                                  "quadruped/canter.toml",
                                  "quadruped/crawl.toml",
                                  "quadruped/pronk.toml",
                                  "quadruped/rotary_gallop.toml",
                                  "quadruped/transverse_gallop.toml",
                                  "hexapod/ripple.toml",
                                  "hexapod/wave.toml",
                                  "biped/run.toml"};

const std::map<std::string, int> kFeet{
    {"biped", 2}, {"puppy", 4}, {"quadruped", 4}, {"piston_puppy", 4}, {"hexapod", 6}};

/// The gaits that tasks of the examples name, by number of feet.
std::map<int, std::set<std::string>> gaits_of_examples() {
  std::map<int, std::set<std::string>> found;
  for (const auto& [robot, feet] : kFeet) {
    for (const auto& entry : fs::directory_iterator(test::kExamples / robot)) {
      if (entry.path().extension() != ".toml") continue;
      const std::string text = read_file(entry.path());
      for (const GaitPattern& pattern : gait_library(feet)) {
        std::string table("gait]\nname = \"");  // [gait], or [task.gait] of a joint task
        if (test::contains(text, table.append(pattern.name).append("\"")))
          found[feet].insert(pattern.name);
      }
    }
  }
  return found;
}

TEST(GaitExamples, EachGaitHasATask) {
  std::map<int, std::set<std::string>> found = gaits_of_examples();
  for (int feet : {2, 4, 6})
    for (const GaitPattern& pattern : gait_library(feet))
      EXPECT_TRUE(found[feet].contains(pattern.name)) << pattern.name << " on " << feet << " feet";
}

/// On one foot at a time nothing holds the heading (docs/findings/heading_drift.md).
const std::set<std::string> kDrift{"biped/run.toml"};

/// What keeps its verdict only as long as nobody asks other numerics, and is told so
/// (docs/findings/physics_in_the_search.md).
const std::set<std::string> kOtherNumerics{"quadruped/bound.toml", "quadruped/rotary_gallop.toml",
                                           "quadruped/transverse_gallop.toml"};

class GaitExample : public testing::TestWithParam<const char*> {};

TEST_P(GaitExample, PassesAtHalfDefaultAndDoubleGains) {
  const test::TemporaryFolder folder;
  const test::JudgedExample judged = test::judge_example(GetParam(), folder.path() / "run");
  const bool hangs = kOtherNumerics.contains(GetParam());
  ASSERT_EQ(judged.optimize, hangs || kDrift.contains(GetParam()) ? 1 : 0) << judged.told;
  const std::string why = Json::parse(read_file(folder.path() / "run/run.json"))["reasons"].dump();
  EXPECT_EQ(test::contains(why, "with a pyramidal cone"), hangs) << why;
  EXPECT_LE(judged.validate, 1) << judged.told;
  const Json verdict = Json::parse(read_file(folder.path() / "run/result/verdict.json"));
  const auto failing = test::failing_limits(verdict["result"]);
  if (!kDrift.contains(GetParam())) {
    EXPECT_TRUE(failing.empty()) << verdict["result"]["line"];
  }
  for (const std::string& name : failing)
    EXPECT_TRUE(test::kDriftLimits.contains(name)) << name << "\n" << verdict["result"]["line"];
}

INSTANTIATE_TEST_SUITE_P(Library, GaitExample, testing::ValuesIn(kTasks), [](const auto& instance) {
  const fs::path task(instance.param);
  return task.parent_path().string() + "_" + task.stem().string();
});

}  // namespace
}  // namespace legwright
