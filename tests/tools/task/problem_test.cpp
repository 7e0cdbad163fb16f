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
  const VectorXd s = problem.robot.space.initial(), m = initial_guess(*problem.outers[0], s);
  int live = 0;
  for (const TermValue& term : problem.outers[0]->terms(s, m)) live += term.value != 0.0;
  EXPECT_LE(live, 1);
  const CodesignProblem half = read("\n[outer]\nobjective = \"mechanical_work\"\n");
  const auto value = [&](const CodesignProblem& of, const VectorXd& motion) {
    return of.outers[0]->evaluate(s, motion, Order::value).value;
  };
  const VectorXd moving =
      m + 0.01 * VectorXd::LinSpaced(m.size(), 0.0, 300.0).array().sin().matrix();
  EXPECT_GT(value(half, moving), 0.0);
  EXPECT_NEAR(value(problem, moving), 2.0 * value(half, moving), 1e-9 * value(problem, moving));
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
