// SPDX-License-Identifier: Apache-2.0
// From an assembly of real servos to a robot that walks in MuJoCo, without a hand edit.
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

const fs::path kPuppyAssembly = kExamples / "assemblies/puppy.toml",
               kHexapodAssembly = kExamples / "assemblies/hexapod.toml";

TEST(Assemblies, APuppyIsBuiltOptimizedAndPasses) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "puppy.xml", task = folder.path() / "trot.toml",
                 run = folder.path() / "run";
  const Outcome built =
      call({"build", kPuppyAssembly.string(), "-o", robot.string(), "--task", task.string()});
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_TRUE(contains(built.out, "puppy: 0.9731 kg, 4 legs, 8 joints that move")) << built.out;
  EXPECT_TRUE(contains(built.out, "next: legwright optimize ")) << built.out;
  EXPECT_TRUE(contains(read_file(task), "name = \"trot\""));
  const Outcome found = call(
      {"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-reasons", "--quiet"});
  ASSERT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(contains(read_file(run / "result/scene.xml"),
                       "<config key=\"stall_torque\" value=\"1.4 1.4 1.4 1.4 1.4 1.4 1.4 1.4\"/>"));
  const Outcome verdict = call({"validate", run.string()});
  EXPECT_EQ(verdict.code, 0) << verdict.out << verdict.err;
  // What is printed goes with the robot, also as URDF.
  const fs::path exported = folder.path() / "exported";
  const Outcome put =
      call({"export", run.string(), "-o", exported.string(), "--urdf", "--no-picture"});
  ASSERT_EQ(put.code, 0) << put.err;
  EXPECT_TRUE(contains(read_file(exported / "urdf/puppy.urdf"), "meshes/FL_thigh_arm.obj"));
  EXPECT_TRUE(fs::exists(exported / "urdf/meshes/FL_thigh_arm.obj"));
}

/// The lines of a text that hold a word, or those that do not.
std::string lines_of(const std::string& text, const std::string& word, bool with) {
  std::istringstream in(text);
  std::string out, line;
  while (std::getline(in, line))
    if (contains(line, word.c_str()) == with) out += line + "\n";
  return out;
}

/// All its joints are about the lateral axis, so it cannot go sideways with the body as drawn: axes
/// turn, and the servos with them.
TEST(Assemblies, APuppyOfLateralAxesTurnsItsServosToGoSideways) {
  LEGWRIGHT_LONG_TEST();
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "puppy.xml", task = folder.path() / "sideways.toml",
                 run = folder.path() / "run";
  const fs::path assembly = kExamples / "assemblies/sideways_puppy.toml";
  ASSERT_EQ(call({"build", assembly.string(), "-o", robot.string(), "--task", task.string()}).code,
            0);
  std::string text = read_file(task);
  const std::size_t at = text.find("velocity = [");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, text.find(']', at) + 1 - at, "velocity = [0.0, 0.05]");
  write_file(task, text);
  const Outcome found = call(
      {"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-reasons", "--quiet"});
  ASSERT_EQ(found.code, 0) << found.out << found.err;
  // In all other numerics, too: with a pyramidal cone at half gains its feet slip otherwise.
  const Outcome verdict = call({"validate", "--samples", "0", run.string()});
  EXPECT_EQ(verdict.code, 0) << verdict.out << verdict.err;
  EXPECT_TRUE(contains(verdict.out, "trot sideways at 0.050 m/s")) << verdict.out;
  EXPECT_TRUE(
      contains(lines_of(read_file(run / "result/robot.xml"), "HL_hip_servo\" pos", true), "quat="));
}

/// The puppy above passes though its motors have less left the faster they run; a plan that does
/// not know so fails with the same motors.
TEST(Assemblies, APlanThatDoesNotKnowItsMotorsFailsWithThem) {
  LEGWRIGHT_LONG_TEST();
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "puppy.xml", task = folder.path() / "trot.toml",
                 run = folder.path() / "run";
  ASSERT_EQ(
      call({"build", kPuppyAssembly.string(), "-o", robot.string(), "--task", task.string()}).code,
      0);
  const std::string built = read_file(robot);
  EXPECT_TRUE(contains(lines_of(built, "legwright_motor/FL_knee", true), "1.4 5.96903")) << built;
  write_file(robot, lines_of(built, "legwright_motor", false));
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-reasons",
                  "--quiet"})
                .code,
            0);
  const fs::path scene = run / "result/scene.xml";
  std::string text = read_file(scene);
  text.insert(text.find("<config key=\"period\""),
              "<config key=\"stall_torque\" value=\"1.4\"/>"
              "<config key=\"no_load_speed\" value=\"5.97\"/>");
  write_file(scene, text);
  test::forget_sums_of_scenes(run);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, 1) << verdict.err;
  EXPECT_TRUE(contains(verdict.out, "saturates servos")) << verdict.out;
}

/// As a user goes on who has no --task yet.
TEST(Assemblies, AHexapodGetsItsTaskFromInitAndPasses) {
  LEGWRIGHT_LONG_TEST();
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "hexapod.xml", task = folder.path() / "tripod.toml",
                 run = folder.path() / "run";
  const Outcome built = call({"build", kHexapodAssembly.string(), "-o", robot.string()});
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_TRUE(contains(built.out, "HL_coxa_servo (line 20) stands 6.4 mm inside HL_femur_servo"));
  EXPECT_FALSE(contains(lines_of(built.out, "stands 6.4 mm", false), "note ")) << built.out;
  const std::string written = read_file(robot);
  ASSERT_EQ(call({"init", robot.string(), "--task", task.string()}).code, 0);
  EXPECT_EQ(read_file(robot), written) << "nothing was left to declare";
  ASSERT_EQ(call({"optimize", task.string(), "-o", run.string(), "--no-pictures", "--no-reasons",
                  "--quiet"})
                .code,
            0);
  const Outcome verdict = call({"validate", "--quick", run.string()});
  EXPECT_EQ(verdict.code, 0) << verdict.out << verdict.err;
}

TEST(Assemblies, AnotherServoIsOneEdit) {
  const test::TemporaryFolder folder;
  std::string text = read_file(kPuppyAssembly);
  const std::string servo = "XL430-W250";
  text.replace(text.find(servo), servo.size(), "XM430-W350");
  const fs::path assembly = folder.path() / "puppy.toml", robot = folder.path() / "puppy.xml";
  write_file(assembly, text);
  const Outcome built = call({"build", assembly.string(), "-o", robot.string(), "--json"});
  ASSERT_EQ(built.code, 0) << built.err;
  const Json json = Json::parse(built.out);
  EXPECT_NEAR(json["mass_kg"].get<double>(), 0.9731 + 8 * (0.082 - 0.0572), 1e-3);
  EXPECT_TRUE(contains(read_file(robot), "forcerange=\"-4.1 4.1\""));
  EXPECT_TRUE(contains(json["notes"][0].get<std::string>(), "reflected inertia is not known"));
  EXPECT_TRUE(contains(json["notes"][0].get<std::string>(), "0.02 kg m2 of XM430-W350"));
}

TEST(Assemblies, WhatIsWrongIsToldAndNothingWritten) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", task = folder.path() / "task.toml",
                 assembly = folder.path() / "a.toml";
  std::string text = read_file(kPuppyAssembly);
  text.replace(text.find("ball_foot_12"), 12, "ball_foot_13");
  write_file(assembly, text);
  const Outcome typo =
      call({"build", assembly.string(), "-o", robot.string(), "--task", task.string()});
  EXPECT_EQ(typo.code, 2);
  EXPECT_TRUE(contains(typo.err, "did you mean \"ball_foot_12\"?")) << typo.err;
  EXPECT_FALSE(fs::exists(robot) || fs::exists(task));
  EXPECT_EQ(call({"build", kPuppyAssembly.string()}).code, 2) << "where to?";
  EXPECT_EQ(call({"build", (folder.path() / "gone.toml").string(), "-o", robot.string()}).code, 3);
  write_file(robot, "mine");
  const Outcome there = call({"build", kPuppyAssembly.string(), "-o", robot.string()});
  EXPECT_EQ(there.code, 3);
  EXPECT_EQ(read_file(robot), "mine");
  fs::remove(robot);
  const Outcome gait = call({"build", kPuppyAssembly.string(), "-o", robot.string(), "--task",
                             task.string(), "--gait", "tripod"});
  EXPECT_EQ(gait.code, 2);
  EXPECT_FALSE(fs::exists(robot)) << "nothing half-written";
  text = read_file(kPuppyAssembly);
  text.replace(text.find("copies = 2"), 10, "copies = 1");
  text.replace(text.find("names = [\"F\", \"H\"]"), 18, "names = [\"F\"]");
  write_file(assembly, text);
  const Outcome biped =
      call({"build", assembly.string(), "-o", robot.string(), "--task", task.string()});
  EXPECT_EQ(biped.code, 2);
  EXPECT_TRUE(contains(biped.err, "two small feet")) << biped.err;
  EXPECT_TRUE(contains(biped.err, "without --task the robot is written")) << biped.err;
  EXPECT_EQ(call({"build", assembly.string(), "-o", robot.string()}).code, 0);
}

TEST(Assemblies, NoFileIsWrittenOverAnother) {
  const test::TemporaryFolder folder;
  const fs::path assembly = folder.path() / "puppy.toml", robot = folder.path() / "a.xml";
  const std::string text = read_file(kPuppyAssembly);
  write_file(assembly, text);
  const auto refused = [&](const fs::path& output, const fs::path& task) {
    const Outcome told =
        call({"build", assembly.string(), "-o", output.string(), "--task", task.string()});
    EXPECT_EQ(told.code, 2) << told.err;
    EXPECT_TRUE(contains(told.err, "name another file")) << told.err;
    EXPECT_FALSE(fs::exists(robot));
    EXPECT_EQ(read_file(assembly), text);
  };
  refused(robot, robot);
  refused(robot, folder.path() / "." / "none" / ".." / "a.xml");
  refused(assembly, folder.path() / "task.toml");
  refused(robot, assembly);
}

TEST(Assemblies, NothingHalfWrittenStays) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "file", "");
  const fs::path robot = folder.path() / "new" / "deep" / "x.xml",
                 task = folder.path() / "file" / "task.toml";
  const Outcome told =
      call({"build", kPuppyAssembly.string(), "-o", robot.string(), "--task", task.string()});
  EXPECT_EQ(told.code, 3) << told.err;
  EXPECT_FALSE(fs::exists(folder.path() / "new")) << "neither robot nor folder";
  const fs::path possible = folder.path() / "tasks" / "task.toml";
  const Outcome again =
      call({"build", kPuppyAssembly.string(), "-o", robot.string(), "--task", possible.string()});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(read_file(possible), "../new/deep/x.xml"));
  EXPECT_TRUE(fs::exists(robot));
}

/// Legs that stand up and cannot turn down.
TEST(Assemblies, ARobotThatDoesNotStandIsRefused) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml", assembly = folder.path() / "a.toml";
  std::string text = read_file(kPuppyAssembly);
  for (std::size_t at; (at = text.find("-0.09")) != std::string::npos;) text.erase(at, 1);
  for (const char* joint : {"{ name = \"hip\"", "{ name = \"knee\""})
    text.insert(text.find(joint) + 1, " range = [-0.1, 0.1],");
  write_file(assembly, text);
  const Outcome told = call({"build", assembly.string(), "-o", robot.string()});
  EXPECT_EQ(told.code, 2);
  EXPECT_TRUE(contains(told.err, "a.toml: its robot is refused and not written; of ")) << told.err;
  EXPECT_TRUE(contains(told.err, "does not stand")) << told.err;
  EXPECT_FALSE(fs::exists(robot));
}

TEST(Assemblies, KeysAreTold) {
  const Outcome told = call({"build", "--keys"});
  EXPECT_EQ(told.code, 0);
  EXPECT_TRUE(contains(told.out, "\nlimb.joint.axis = ")) << told.out;
  EXPECT_EQ(Json::parse(call({"build", "--keys", "--json"}).out)["schema"],
            "legwright/assembly_keys");
}

}  // namespace
}  // namespace legwright
