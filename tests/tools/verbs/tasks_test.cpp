// SPDX-License-Identifier: Apache-2.0
// Tasks of examples/tasks on a robot that their file does not name, from task file to report.
#include <gtest/gtest.h>

#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;

class TaskOnAnotherRobot : public testing::Test, protected test::CallsInFolder {
 protected:
  /// Co-designs, validates and reports; the folder of the run.
  fs::path run(const std::string& task, const std::string& robot,
               const std::vector<std::string>& more = {"--no-reasons"}) const {
    std::vector<std::string> words{"optimize",
                                   (test::kExamples / "tasks" / task).string(),
                                   "--robot",
                                   (test::kExamples / robot / "robot.xml").string(),
                                   "--no-pictures",
                                   "--no-certificate",
                                   "-o",
                                   "run"};
    words.insert(words.end(), more.begin(), more.end());
    const test::Outcome optimize = call(words);
    EXPECT_EQ(optimize.code, 0) << optimize.err;
    const test::Outcome validate = call({"validate", "run", "--quick"});
    EXPECT_EQ(validate.code, 0) << validate.out << validate.err;
    EXPECT_EQ(call({"report", "run"}).code, 0);
    return folder_.path() / "run";
  }
  static Json read(const fs::path& file) { return Json::parse(read_file(file)); }
};

TEST_F(TaskOnAnotherRobot, UpASlope) {
  const fs::path folder = run("slope.toml", "quadruped", {});
  const Json run = read(folder / "run.json"), verdict = read(folder / "result/verdict.json");
  EXPECT_EQ(run["robot"], "quadruped");
  EXPECT_LT(run["root_residual"].get<double>(), 0.02);  // plan and scene have one gravity
  EXPECT_FALSE(verdict["initial"]["pass"].get<bool>());
  EXPECT_TRUE(contains(read_file(folder / "result/scene.xml"), "<option gravity=\"-"));
  EXPECT_FALSE(contains(read_file(folder / "result/robot.xml"), "gravity"));
  const std::string summary = read_file(folder / "result/summary.md");
  EXPECT_TRUE(contains(summary, "up a slope of 8.59°")) << summary;
  EXPECT_TRUE(contains(summary, "**What the body bought.** The initial body")) << summary;
  EXPECT_TRUE(contains(read_file(folder / "report.html"), "Why the body changed"));
}

TEST_F(TaskOnAnotherRobot, WithAPayload) {
  const fs::path folder = run("payload.toml", "quadruped");
  const Json run = read(folder / "run.json"), metrics = read(folder / "result/metrics.json");
  EXPECT_LT(run["root_residual"].get<double>(), 0.02);  // plan and scene weigh the same
  EXPECT_NEAR(metrics["robot_mass_kg"]["result"].get<double>(),
              run["body"]["final"]["mass_kg"].get<double>() + 1.0, 1e-9);
  EXPECT_TRUE(contains(read_file(folder / "result/scene.xml"), "name=\"payload\""));
  EXPECT_FALSE(contains(read_file(folder / "result/robot.xml"), "payload"));
  // The run can be told again from its own inputs, without --robot.
  const test::Outcome again = call({"check", "run/inputs/task.toml"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(again.out, "robot   quadruped")) << again.out;
  EXPECT_TRUE(contains(again.out, "payload 1 kg at 0, 0, 0.06 m of the trunk")) << again.out;
}

TEST_F(TaskOnAnotherRobot, OverABarAndThatIsMeasured) {
  const fs::path folder = run("step_over.toml", "puppy");
  const Json verdict = read(folder / "result/verdict.json");
  bool judged = false;
  for (const Json& row : verdict["result"]["limits"])
    if (row["name"] == "foot_clearance") {
      judged = true;
      EXPECT_EQ(row["low"].get<double>(), 0.03);
      EXPECT_GE(row["value"].get<double>(), 0.03);
    }
  EXPECT_TRUE(judged);
  // A higher bar than these steps are fails, and nothing else does.
  write_file(folder_.path() / "limits.toml", "foot_clearance.low = 0.06\n");
  const test::Outcome higher = call({"validate", "run", "--quick", "--limits", "limits.toml"});
  EXPECT_EQ(higher.code, 1);
  EXPECT_TRUE(
      contains(higher.out, "co-designed robot:  FAIL  walk forward at 0.100 m/s: steps over"))
      << higher.out;
}

TEST_F(TaskOnAnotherRobot, WithWeakerMotorsWhereItIsPlayed) {
  const fs::path folder = run("smaller_motor.toml", "quadruped");
  const Json metrics = read(folder / "result/metrics.json");
  for (const Json& joint : metrics["result"]["default"]["joints"]) {
    EXPECT_EQ(joint["torque_limit_Nm"].get<double>(), 1.5);
    EXPECT_LT(joint["torque_peak_Nm"].get<double>(), 1.5);
  }
}

TEST(RobotOption, NamesAFileThatMustBeThere) {
  const test::Outcome outcome = test::call(
      {"optimize", (test::kExamples / "tasks/slope.toml").string(), "--robot", "no.xml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "no.xml: no such file")) << outcome.err;
}

}  // namespace
}  // namespace legwright
