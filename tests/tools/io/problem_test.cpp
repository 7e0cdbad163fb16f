// SPDX-License-Identifier: Apache-2.0
#include "tools/io/problem.hpp"

#include <gtest/gtest.h>

#include "mjcf/input_error.hpp"
#include "tests/tools/io/temporary_folder.hpp"
#include "tools/io/certificate_json.hpp"
#include "tools/io/pull.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Eigen::VectorXd;

const fs::path kExamples = fs::path(LEGWRIGHT_SOURCE_DIR) / "examples";

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

/// The puppy with its hips turned outwards, so that it can do the task, on few knots.
struct Solved {
  CodesignProblem problem = read_problem(kExamples / "puppy" / "sideways.toml");
  const Objective& objective = *problem.objectives[0];
  VectorXd s = problem.robot.space.initial(), m;

  Solved() {
    s[6] = s[12] = 0.5;
    m = initial_guess(objective, s);
    const SolveReport report = newton(objective, s, m, {.tolerance = 1e-8, .max_iterations = 400});
    EXPECT_EQ(report.status, SolveStatus::converged);
  }
};

TEST(Pull, SharesOfAllTermsMakeTheDecreaseOfF) {
  const Solved from;
  const auto sensitivity = [&](const VectorXd& s, const VectorXd& m) {
    const Evaluation at = from.objective.evaluate(s, m, Order::design);
    HessianFactor factor;
    EXPECT_TRUE(factor.factor(at.hessian_mm, {}));
    Eigen::MatrixXd x;
    EXPECT_TRUE(factor.solve(at.hessian_ms, x));
    return Eigen::MatrixXd(-x);
  };
  VectorXd s = from.s, m = from.m;
  s[6] += 0.004;
  s[18] *= 1.004;
  ASSERT_EQ(newton(from.objective, s, m, {.tolerance = 1e-8, .max_iterations = 100}).status,
            SolveStatus::converged);
  PullAlongPath pull;
  pull.add(from.objective, from.s, from.m, sensitivity(from.s, from.m));
  EXPECT_EQ(pull.decrease().norm(), 0.0);
  pull.add(from.objective, s, m, sensitivity(s, m));
  const double fallen = from.objective.evaluate(from.s, from.m, Order::value).value -
                        from.objective.evaluate(s, m, Order::value).value;
  EXPECT_GT(std::abs(fallen), 1e-3);
  EXPECT_NEAR(pull.decrease().sum(), fallen, 1e-9 * std::abs(fallen));
  // Only what was changed has a share.
  for (int k = 0; k < pull.decrease().cols(); ++k) {
    if (k != 6 && k != 18) {
      EXPECT_EQ(pull.decrease().col(k).norm(), 0.0) << k;
    }
  }
  const Json told = pull.to_json(from.problem.robot.space, 1.0);
  EXPECT_FALSE(told[from.problem.robot.space.parameters[6].name].empty());
  // Without dm/ds the shares are those at fixed m, and miss what the motion makes of them.
  PullAlongPath fixed;
  fixed.add(from.objective, from.s, from.m, {});
  fixed.add(from.objective, s, m, {});
  EXPECT_GT((fixed.decrease() - pull.decrease()).norm(), 0.1 * pull.decrease().norm());
}

TEST(WorstConstraints, SayWhereWhenAndByHowMuch) {
  const Solved good;
  const auto about_feet = [](const std::vector<std::string>& all) {
    int count = 0;
    for (const std::string& text : all) count += text.starts_with("foot position");
    return count;
  };
  EXPECT_EQ(about_feet(worst_constraints(good.objective, good.s, good.m, 3)), 0)
      << "a solved plan has its feet where its legs end";
  VectorXd bad = good.m;
  const int slot = good.objective.layout().foot(5, 2) - good.objective.layout().design_size() + 2;
  bad[slot] += 0.02;  // a foot 2 cm from where its leg is
  const std::vector<std::string> words = worst_constraints(good.objective, good.s, bad, 3);
  ASSERT_EQ(words.size(), 3u);
  const std::string& name = good.objective.morphology().feet[2].name;
  bool told = false;
  for (const std::string& text : words)
    told = told || (text.find(name) != std::string::npos && text.find("mm") != std::string::npos &&
                    text.find(" s, by") != std::string::npos);
  EXPECT_TRUE(told) << words[0] << "\n" << words[1] << "\n" << words[2];
}

}  // namespace
}  // namespace legwright
