// SPDX-License-Identifier: Apache-2.0
#include "tools/task/problem.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Eigen::VectorXd;

using test::kExamples;

TEST(Problem, HasOneObjectiveForEachTask) {
  const CodesignProblem problem = read_problem(kExamples / "quadruped" / "both.toml");
  ASSERT_EQ(problem.task_count(), 2);
  EXPECT_EQ(problem.objectives[0]->task().name, "pace");
  EXPECT_EQ(problem.objectives[1]->task().gait.name(), "walk");
  EXPECT_TRUE(problem.outers.empty());
  EXPECT_EQ(problem.speed_unit(0), "m/s");
  const ProblemCosts costs(problem);
  ASSERT_EQ(costs.tasks().size(), 2u);
  const VectorXd s = problem.robot.space.initial();
  EXPECT_EQ(costs.tasks()[1].guess(s).size(), problem.objectives[1]->layout().motion_size());
}

/// A task file beside the puppy, with something added.
class WithOuter : public testing::Test {
 protected:
  CodesignProblem read(const std::string& more) {
    fs::copy_file(kExamples / "puppy" / "robot.xml", folder_.path() / "robot.xml",
                  fs::copy_options::overwrite_existing);
    const fs::path file = folder_.path() / "task.toml";
    write_file(file, read_file(kExamples / "puppy" / "sideways.toml") + more);
    return read_problem(file);
  }
  test::TemporaryFolder folder_;
};

TEST_F(WithOuter, JIsOneTermAndNothingElse) {
  const CodesignProblem problem =
      read("\n[outer]\nobjective = \"mechanical_work\"\nweight = 2.0\n");
  ASSERT_EQ(problem.outers.size(), 1u);
  const auto& J = dynamic_cast<const OuterTerm&>(*problem.outers[0]);
  const VectorXd s = problem.robot.space.initial(), m = initial_guess(J.quantity(), s);
  int live = 0;
  for (const TermValue& term : J.quantity().terms(s, m)) live += term.value != 0.0;
  EXPECT_EQ(live, 1);
  EXPECT_EQ(J.unit(), "J");
  // Of the first guess of the given body J is its weight.
  EXPECT_DOUBLE_EQ(J.cost(J.amount_at(s, m)), 2.0);
  Evaluation at;
  J.make_cost()->evaluate(s, m, Order::value, at);
  EXPECT_DOUBLE_EQ(at.value, 2.0);
}

TEST_F(WithOuter, ThePeakCountsHalfTheWeightOnALevelLeg) {
  const CodesignProblem problem = read("\n[outer]\nobjective = \"peak_torque\"\n");
  const Morphology& robot = problem.robot.morphology;
  const OuterObjective& J = *problem.outers[0];
  EXPECT_EQ(J.unit(), "N m");
  EXPECT_DOUBLE_EQ(J.reference(), 0.5 * robot.total_mass() * kGravity * robot.leg_length);
}

TEST_F(WithOuter, WhatTheRobotDoesNotHaveIsRefused) {
  try {
    (void)read("\n[outer]\nobjective = \"printed_volume\"\n");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* part : {"outer.objective", "no printed volume", "take out [outer]"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST_F(WithOuter, AnUnknownOneIsRefusedWithThoseThatThereAre) {
  try {
    (void)read("\n[outer]\nobjective = \"beauty\"\n");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* part : {"outer.objective", "beauty", "mechanical_work", "peak_torque"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace legwright
