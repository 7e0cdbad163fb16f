// SPDX-License-Identifier: Apache-2.0
// The promise of the examples, from task file to verdict: the initial puppy does not go sideways,
// the co-designed one does, at half, default and double gains.
#include <gtest/gtest.h>

#include "tests/support/long_tests.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class Sideways : public testing::TestWithParam<const char*>, protected test::CallsInFolder {};

TEST_P(Sideways, CoDesignedPuppyDoesWhatTheInitialOneDoesNot) {
  const std::string task = (test::kExamples / "puppy" / GetParam()).string();
  const test::Outcome optimize = call({"optimize", task, "--no-pictures", "-o", "run"});
  ASSERT_EQ(optimize.code, 0) << optimize.err;
  // What physics says of the bodies beside it: of the result itself, that it passes; of the given
  // body with one change, that it does not.
  const Json run = Json::parse(read_file(folder_.path() / "run" / "run.json"));
  for (const Json& row : run["put_back"])
    EXPECT_EQ(row.contains("played"),
              std::abs(row["F"].get<double>()) > 0.01 * run["final_F"].get<double>())
        << row["parameter"];
  const Json& fewest = run["fewest_changes"]["designs"];
  EXPECT_TRUE(fewest.front()["played"]["pass"].get<bool>()) << fewest.front();
  EXPECT_FALSE(fewest.back()["played"]["pass"].get<bool>()) << fewest.back();

  const test::Outcome validate = call({"validate", "run", "--quick"});
  EXPECT_EQ(validate.code, 0) << validate.out << validate.err;
  const fs::path result = folder_.path() / "run" / "result";
  const Json verdict = Json::parse(read_file(result / "verdict.json"));
  EXPECT_FALSE(verdict["initial"]["pass"].get<bool>());
  EXPECT_TRUE(verdict["result"]["pass"].get<bool>());
  const Json metrics = Json::parse(read_file(result / "metrics.json"));
  for (const char* gains : {"half", "default", "double"}) {
    const Json& initial = metrics["initial"][gains];
    const Json& designed = metrics["result"][gains];
    EXPECT_TRUE(!initial["fall"].is_null() || initial["speed_ratio"].get<double>() < 0.2) << gains;
    EXPECT_TRUE(designed["fall"].is_null()) << gains;
    EXPECT_EQ(designed["cycles"], 20) << gains;
    EXPECT_NEAR(designed["speed_ratio"].get<double>(), 1.0, 0.05) << gains;
    EXPECT_LT(designed["tilt_max_rad"].get<double>(), 0.1) << gains;
    EXPECT_LT(designed["saturated_share"].get<double>(), 1e-3) << gains;
  }
}

TEST_P(Sideways, ReportAndPicturesCome) {
  if (std::string(GetParam()) == "sideways.toml") {
    LEGWRIGHT_LONG_TEST();
  }
  const std::string task = (test::kExamples / "puppy" / GetParam()).string();
  const test::Outcome optimize = call({"optimize", task, "--no-pictures", "--no-reasons",
                                       "--plan-only", "--max-iterations", "1", "-o", "run"});
  ASSERT_LE(optimize.code, 1) << optimize.err;  // one step need not be enough
  (void)call({"validate", "run", "--quick"});
  const test::Outcome render = call({"render", "run"});
  if (render.code == 3) GTEST_SKIP() << "no OSMesa here: " << render.err;
  EXPECT_EQ(render.code, 0) << render.err;
  EXPECT_EQ(call({"report", "run"}).code, 0);
  const fs::path run = folder_.path() / "run";
  for (const char* picture : {"iterations/0000/frame.png", "result/strip_before_after.png"})
    EXPECT_GT(fs::file_size(run / picture), 10000u) << picture;
  const std::string page = read_file(run / "report.html");
  EXPECT_TRUE(test::contains(page, "data:image/png;base64,"));
  EXPECT_TRUE(test::contains(page, "<svg"));
}

class FewChanges : public testing::Test, protected test::CallsInFolder {};

// Whether F's optimum passes or a search with tightened tasks goes on from it: no further parameter
// leaves its old value.
TEST_F(FewChanges, OfTheResultAreThoseOfItsRecord) {
  const std::string task = (test::kExamples / "puppy" / "sideways_trot.toml").string();
  const test::Outcome optimize = call({"optimize", task, "--few", "--max-iterations", "6",
                                       "--no-pictures", "--no-certificate", "-o", "run"});
  ASSERT_LE(optimize.code, 1) << optimize.err;
  const Json run = Json::parse(read_file(folder_.path() / "run" / "run.json"));
  EXPECT_GT(run["choice"]["candidates"].size(), 1U) << "no tightened search: choose another task";
  const Json& fewest = run["fewest_changes"];
  EXPECT_TRUE(fewest["kept"].get<bool>());
  std::vector<std::string> changed;
  for (const Json& parameter : run["parameters"])
    if (parameter["final"] != parameter["initial"])
      changed.push_back(parameter["name"].get<std::string>());
  const Json& few = fewest["designs"][fewest["fewest"].get<std::size_t>()];
  EXPECT_EQ(Json(changed), few["changed"]);
  EXPECT_LT(changed.size(), 10U) << "of 20";
}

INSTANTIATE_TEST_SUITE_P(Puppy, Sideways, testing::Values("sideways.toml", "sideways_trot.toml"));

}  // namespace
}  // namespace legwright
