// SPDX-License-Identifier: Apache-2.0
// What a task may ask for beyond a way to go: slope, payload, steps over a height, weaker motors,
// another robot.
#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/run_json.hpp"
#include "tools/task/problem.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kExamples;

std::string text_with(const std::string& rest,
                      const std::string& travel = "velocity = [0.1, 0.0]") {
  return "robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\n" + travel +
         "\n" + rest;
}

Task task_with(const std::string& rest, const std::string& travel = "velocity = [0.1, 0.0]") {
  static const RobotModel puppy = read_robot(kExamples / "puppy/robot.xml");
  return make_task(parse_task_file(text_with(rest, travel), kExamples / "puppy/test.toml"), puppy);
}

std::string complaint(const std::string& rest,
                      const std::string& travel = "velocity = [0.1, 0.0]") {
  try {
    task_with(rest, travel);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_complaint(const std::string& rest, const std::string& part) {
  const std::string said = complaint(rest);
  EXPECT_NE(said.find("test.toml:" + part), std::string::npos) << rest << "\n" << said;
}

TEST(TaskDemands, AreNoneByDefault) {
  const Task task = task_with("");
  EXPECT_EQ(task.up, Eigen::Vector3d::UnitZ());
  EXPECT_FALSE(task.payload);
  EXPECT_FALSE(task.torque_limit);
  EXPECT_EQ(task.step_over, 0.0);
  EXPECT_FALSE(task.servo_kp);
}

TEST(TaskDemands, EachTaskMayHaveItsOwnDynamics) {
  const TaskSet set = parse_task_set(
      "robot = \"robot.xml\"\ndynamics = \"constant_inertia\"\n"
      "[[task]]\nname = \"a\"\ngait = {name = \"walk\", period = 1.0}\n"
      "travel = {velocity = [0.1, 0]}\n"
      "[[task]]\nname = \"b\"\ndynamics = \"full\"\ngait = {name = \"walk\", period = 1.0}\n"
      "travel = {velocity = [0.1, 0]}\n",
      test::kPuppy / "test.toml");
  EXPECT_EQ(set.tasks[0].margins.dynamics, Dynamics::constant_inertia);
  EXPECT_EQ(set.tasks[1].margins.dynamics, Dynamics::full);
}

TEST(TaskDemands, AreRead) {
  const Task task = task_with(
      "[ground]\nslope_along = 0.2\nslope_across = -0.1\n"
      "[payload]\nmass = 0.5\nposition = [0.0, 0.01, 0.06]\nsize = [0.1, 0.08, 0.06]\n"
      "[limits]\ntorque_limit = 1.5\nstep_over = 0.03\n[servos]\nkp = 120\nkd = 1.5\n");
  EXPECT_EQ(task.servo_kp, 120.0);
  EXPECT_EQ(task.servo_kd, 1.5);
  const SlopeAngles slope = slope_of(task.velocity, task.up);
  EXPECT_NEAR(slope.along, 0.2, 1e-14);
  EXPECT_NEAR(slope.across, -0.1, 1e-14);
  ASSERT_TRUE(task.payload);
  EXPECT_EQ(task.payload->mass, 0.5);
  EXPECT_EQ(task.payload->position, Eigen::Vector3d(0.0, 0.01, 0.06));
  EXPECT_EQ(task.payload->size, Eigen::Vector3d(0.1, 0.08, 0.06));
  EXPECT_EQ(task.torque_limit, 1.5);
  EXPECT_EQ(task.step_over, 0.03);
  EXPECT_NEAR(task.swing_height.value(), 2.25 * 0.03, 1e-15);  // the plan swings higher
}

TEST(TaskDemands, APayloadIsACubeOfWaterUnlessTheFileSaysOtherwise) {
  const Task task = task_with("[payload]\nmass = 1\n");
  EXPECT_LT((task.payload->size - Eigen::Vector3d::Constant(0.1)).norm(), 1e-12);
  EXPECT_EQ(task.payload->position, Eigen::Vector3d::Zero());
}

TEST(TaskDemands, ALowBarLeavesTheSwingAsItIs) {
  EXPECT_EQ(task_with("[limits]\nstep_over = 0.01\n").swing_height, task_with("").swing_height);
  EXPECT_EQ(task_with("[limits]\nstep_over = 0.03\nswing_height = 0.035\n").swing_height, 0.035);
}

TEST(TaskDemands, HoldForAllTasksOfAFileThatDoNotSayOtherwise) {
  const TaskSet set = parse_task_set(
      "robot = \"robot.xml\"\n[payload]\nmass = 0.4\n[ground]\nslope_along = 0.1\n"
      "[[task]]\nname = \"up\"\ngait = {name = \"walk\", period = 1}\ntravel = {velocity = [0.1, "
      "0]}\n"
      "[[task]]\nname = \"down\"\ngait = {name = \"walk\", period = 1}\n"
      "travel = {velocity = [0.1, 0]}\nground = {slope_along = -0.1}\npayload = {mass = 0.2}\n",
      kExamples / "puppy/test.toml");
  EXPECT_EQ(set.tasks[0].slope_along, 0.1);
  EXPECT_EQ(set.tasks[0].margins.payload->mass, 0.4);
  EXPECT_EQ(set.tasks[1].slope_along, -0.1);
  EXPECT_EQ(set.tasks[1].margins.payload->mass, 0.2);
}

TEST(TaskDemands, WrongOnesAreRefusedWithKeyAndLine) {
  expect_complaint("[ground]\nslope_along = 1.2\n", "8: ground.slope_along: is 1.2; expected");
  expect_complaint("[ground]\nslope = 0.1\n",
                   "8: ground.slope: unknown key; known here: slope_along");
  expect_complaint("[payload]\nmass = 0\n", "8: payload.mass: is 0; expected 0 < mass");
  expect_complaint("[payload]\nmass = nan\n", "8: payload.mass:");
  expect_complaint("[payload]\nmass = 1\nposition = [0, 0]\n", "9: payload.position: ");
  expect_complaint("[payload]\nmass = 1\nsize = [0.1, 0, 0.1]\n", "9: payload.size");
  expect_complaint("[payload]\nsize = [0.1, 0.1, 0.1]\n", "7: payload.mass: is missing");
  expect_complaint("[limits]\ntorque_limit = 0\n", "8: limits.torque_limit: is 0; expected 0 <");
  expect_complaint("[servos]\nkp = 0\n", "8: servos.kp: is 0; expected 0 <");
  expect_complaint("[servos]\nkd = 1\n", "7: servos.kp: is missing");
  expect_complaint("[limits]\nstep_over = -0.01\n", "8: limits.step_over: ");
  expect_complaint("[limits]\nswing_height = 0.02\nstep_over = 0.03\n",
                   "8: limits.swing_height: steps over 0.03 m are asked for");
}

TEST(TaskDemands, AWayThatTurnsHasNoSlope) {
  const std::string turning = "velocity = [0.1, 0.0]\nturn_rate = 0.2";
  EXPECT_EQ(complaint("", turning), "");
  const std::string said = complaint("[ground]\nslope_across = 0.1\n", turning);
  EXPECT_NE(said.find("test.toml:7: travel.turn_rate: is 0.2 rad/s on a slope"), std::string::npos)
      << said;
}

TEST(TaskDemands, AnotherRobotTakesThePlaceOfTheFilesOwn) {
  const fs::path task = kExamples / "tasks/payload.toml";
  EXPECT_EQ(read_problem(task).robot.morphology.name, "puppy");
  const fs::path other = kExamples / "quadruped/robot.xml";
  const CodesignProblem problem = read_problem(task, other);
  EXPECT_EQ(problem.robot.morphology.name, "quadruped");
  EXPECT_EQ(problem.task(0).robot, other);
  // The file's own robot need not be there then; without one of its own it is asked for.
  const test::TemporaryFolder folder;
  write_file(folder.path() / "lone.toml", text_with(""));
  EXPECT_NO_THROW(read_task_set(folder.path() / "lone.toml", other));
  EXPECT_THROW(read_task_set(folder.path() / "lone.toml"), InputError);
  try {
    read_task_set(task, "no/such.xml");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no/such.xml"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("--robot"), std::string::npos);
  }
}

TEST(TaskDemands, ThePlansRobotIsLadenAndTheFilesIsNot) {
  const CodesignProblem problem = read_problem(kExamples / "tasks/payload.toml");
  const double own = problem.robot.morphology.total_mass();
  EXPECT_NEAR(problem.objectives[0]->morphology().total_mass(), own + 1.0, 1e-9);
  const CodesignProblem weak = read_problem(kExamples / "tasks/smaller_motor.toml");
  EXPECT_EQ(weak.robot.morphology.links[1].joint.torque_limit, 3.0);
  EXPECT_LT(weak.objectives[0]->morphology().links[1].joint.torque_limit, 3.0);
}

Json task_json(const char* file) {
  return json_of(*start_of_run({}, read_problem(kExamples / file), 0).task);
}

TEST(TaskDemands, StandInRunJsonOnlyWhereThereAreAny) {
  const Json with = task_json("tasks/slope.toml");
  EXPECT_NEAR(with["slope_rad"]["along"].get<double>(),
              read_task_file(kExamples / "tasks/slope.toml").slope_along, 1e-12);
  EXPECT_FALSE(with.contains("payload"));
  const Json without = task_json("puppy/sideways.toml");
  for (const char* key : {"slope_rad", "payload", "torque_limit_Nm", "servo_kp_Nm_per_rad",
                          "step_over_m", "dynamics"})
    EXPECT_FALSE(without.contains(key)) << key;
  const Json bar = task_json("tasks/step_over.toml");
  EXPECT_GT(bar["step_over_m"].get<double>(), 0.0);
  const test::TemporaryFolder folder;
  write_file(folder.path() / "paper.toml",
             "dynamics = \"constant_inertia\"\n" + read_file(kExamples / "puppy/sideways.toml"));
  const CodesignProblem papers =
      read_problem(folder.path() / "paper.toml", kExamples / "puppy/robot.xml");
  EXPECT_EQ(json_of(*start_of_run({}, papers, 0).task)["dynamics"], "constant_inertia");
}

}  // namespace
}  // namespace legwright
