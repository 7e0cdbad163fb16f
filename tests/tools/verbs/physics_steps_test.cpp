// SPDX-License-Identifier: Apache-2.0
// optimize --physics-steps: the gait that MuJoCo plays comes closer to the task, and validate
// agrees.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tools/verbs/program.hpp"
#include "tests/tools/verbs/run_schemas.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Mean distance of the speed from the wanted one over the three gains, as validate measures it.
double gap(const fs::path& run) {
  const Json metrics = Json::parse(read_file(run / "result" / "metrics.json"));
  double sum = 0.0;
  for (const char* gains : {"half", "default", "double"})
    sum += std::abs(metrics["result"][gains]["speed_ratio"].get<double>() - 1.0);
  return sum / 3.0;
}

TEST(PhysicsStepsOfOptimize, CloseTheGapBetweenPlanAndPhysics) {
  const test::TemporaryFolder folder;
  const auto call = [&](const std::vector<std::string>& words) {
    return test::call_in(folder.path(), words);
  };
  const std::string task = (test::kExamples / "piston_puppy" / "forward.toml").string();
  const auto optimize = [&](const char* run, std::vector<std::string> more) {
    std::vector<std::string> words{
        "optimize", task, "--no-pictures", "--no-certificate", "--no-reasons", "-o", run};
    words.insert(words.end(), more.begin(), more.end());
    const test::Outcome outcome = call(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
  };
  optimize("plain", {});
  const test::Outcome told = optimize("closed", {"--physics-steps", "1"});
  EXPECT_TRUE(test::contains(told.err, "physics step 1: speed x")) << told.err;
  EXPECT_TRUE(test::contains(told.out, "  physics  before: PASS")) << told.out;
  for (const char* run : {"plain", "closed"})
    EXPECT_EQ(call({"validate", run, "--quick"}).code, 0) << run;
  EXPECT_LT(gap(folder.path() / "closed"), 0.5 * gap(folder.path() / "plain"));

  // The body is the same, only its gait is not; and what was confirmed stands in run.json.
  const auto file = [&](const char* run, const char* name) {
    return read_file(folder.path() / run / "result" / name);
  };
  EXPECT_EQ(file("plain", "robot.xml"), file("closed", "robot.xml"));
  EXPECT_NE(file("plain", "scene.xml"), file("closed", "scene.xml"));
  const Json run = Json::parse(read_file(folder.path() / "closed" / "run.json"));
  EXPECT_EQ(run["scenes"]["result/scene.xml"], sha256_hex(file("closed", "scene.xml")));
  const Json& found = run["physics_steps"];
  EXPECT_TRUE(found["changed"].get<bool>());
  EXPECT_LT(found["after"]["merit"].get<double>(), found["before"]["merit"].get<double>());
  EXPECT_GE(found["scalars"]["margins"].get<double>(), 1.0);
  EXPECT_EQ(test::expect_schemas(folder.path() / "closed")["run"], 1);
}

}  // namespace
}  // namespace legwright
