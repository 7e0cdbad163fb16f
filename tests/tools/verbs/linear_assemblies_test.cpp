// SPDX-License-Identifier: Apache-2.0
// From an assembly whose knees are linear actuators to a robot that walks in MuJoCo.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/long_tests.hpp"
#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::kExamples;
using test::Outcome;

const fs::path kPistonQuadruped = kExamples / "assemblies/piston_quadruped.toml";

/// Builds it with its first task, and lets it go at that speed [m/s]: `init` knows no motors.
void build(const fs::path& robot, const fs::path& task, const std::string& speed) {
  const Outcome built =
      call({"build", kPistonQuadruped.string(), "-o", robot.string(), "--task", task.string()});
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_TRUE(contains(built.out, "reflected mass is not known")) << built.out;
  EXPECT_TRUE(contains(built.out, "`legwright parts` prints none of them")) << built.out;
  std::string text = read_file(task);
  const std::size_t at = text.find("velocity = [");
  ASSERT_NE(at, std::string::npos);
  write_file(task,
             text.replace(at, text.find(']', at) + 1 - at, "velocity = [" + speed + ", 0.0]"));
}

TEST(LinearAssemblies, AQuadrupedOfPistonsWalksAndPasses) {
  LEGWRIGHT_LONG_TEST();
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "trot.toml",
                 run = folder.path() / "run";
  ASSERT_NO_FATAL_FAILURE(build(robot, task, "0.1"));
  const Outcome checked = call({"check", task.string()});
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  const Outcome found = call(
      {"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-reasons", "--quiet"});
  ASSERT_EQ(found.code, 0) << found.out << found.err;
  const Outcome verdict = call({"validate", run.string()});
  EXPECT_EQ(verdict.code, 0) << verdict.out << verdict.err;
  EXPECT_TRUE(contains(verdict.out, "trot forward at 0.100 m/s: ")) << verdict.out;
}

/// A plan that does not know how slow its rods are asks more of them than they have.
TEST(LinearAssemblies, APlanThatDoesNotKnowItsRodsFailsWithThem) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "trot.toml",
                 run = folder.path() / "run";
  ASSERT_NO_FATAL_FAILURE(build(robot, task, "0.1"));
  const std::string built = read_file(robot);
  ASSERT_TRUE(contains(built, "legwright_motor/FL_knee\" data=\"100 0.032\"")) << built;
  std::istringstream lines(built);
  std::string without;
  for (std::string line; std::getline(lines, line);)
    if (!contains(line, "legwright_motor")) without += line + "\n";
  write_file(robot, without);
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-reasons",
                  "--quiet"})
                .code,
            0);
  const fs::path scene = run / "result/scene.xml";
  std::string text = read_file(scene);
  text.insert(
      text.find("<config key=\"period\""),
      "<config key=\"stall_torque\" value=\"1.4 100 1.4 100 1.4 100 1.4 100\"/>"
      "<config key=\"no_load_speed\" value=\"5.97 0.032 5.97 0.032 5.97 0.032 5.97 0.032\"/>");
  write_file(scene, text);
  test::forget_sums_of_scenes(run);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, 1) << verdict.err;
  EXPECT_TRUE(contains(verdict.out, "saturates servos")) << verdict.out;
}

}  // namespace
}  // namespace legwright
