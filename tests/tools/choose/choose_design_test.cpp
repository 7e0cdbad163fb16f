// SPDX-License-Identifier: Apache-2.0
// Physics has the say: the result is the best design that MuJoCo passes.
#include "tools/choose/choose_design.hpp"

#include <gtest/gtest.h>

#include "tests/tools/choose/problems.hpp"
#include "tools/choose/physics_trial.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

/// A problem as `optimize` has searched it.
struct SearchedProblem {
  explicit SearchedProblem(CodesignProblem p) : problem(std::move(p)), costs(problem) {
    MultistartOptions options;
    options.on_iteration = [&](const RunLabel&, const DesignIteration& iteration) {
      along.push_back(iteration);
      return true;
    };
    found = codesign_from_starts(costs.tasks(), problem.robot.space, options);
  }
  ChosenDesign choose(int threads) const {
    ChoiceOptions options;
    options.threads = threads;
    return choose_design(problem, costs.tasks(), found, along, options);
  }
  const CandidateRecord& candidate(const ChosenDesign& choice, const std::string& name) const {
    for (const CandidateRecord& record : choice.record.candidates)
      if (record.name == name) return record;
    throw std::out_of_range(name);
  }

  CodesignProblem problem;
  ProblemCosts costs;
  MultistartResult found;
  std::vector<DesignIteration> along;
};

/// One whose optimum fails, and what is chosen instead of it.
class ChooseDesignInstead : public testing::Test {
 protected:
  static const SearchedProblem& searched() {
    static const SearchedProblem problem(test::canter());
    return problem;
  }
  static const ChosenDesign& choice() {
    static const ChosenDesign chosen = searched().choose(2);
    return chosen;
  }
};

TEST_F(ChooseDesignInstead, HandsBackTheLeastFThatPasses) {
  const SearchedProblem& searched = this->searched();
  const ChosenDesign& choice = this->choice();
  EXPECT_FALSE(searched.candidate(choice, "optimum").played.pass);
  ASSERT_TRUE(choice.record.pass);
  EXPECT_EQ(choice.result.name, choice.record.chosen);
  for (const CandidateRecord& record : choice.record.candidates)
    if (record.played.pass) {
      EXPECT_LE(choice.result.design.value, record.F) << record.name;
    }
  EXPECT_LE(choice.result.design.value, searched.candidate(choice, "initial").F);

  // It passes when it is played again, from its own files.
  load_gait_plugin();
  const GaitTrial again = try_in_physics(
      searched.problem.robot, searched.problem.task(0),
      design_texts(searched.problem.robot, choice.result.objective(searched.problem, 0),
                   choice.result.design.s, choice.result.design.tasks[0].m));
  EXPECT_TRUE(again.pass) << again.line;
  EXPECT_EQ(again.distance, 0.0);

  // What else is worth a look is kept: the optimum, and what passes.
  ASSERT_FALSE(choice.others.empty());
  EXPECT_EQ(choice.others.front().second.name, "optimum");
  for (const auto& [index, other] : choice.others) {
    EXPECT_EQ(choice.record.candidates[index].name, other.name);
    EXPECT_NE(other.name, choice.record.chosen);
  }
}

TEST_F(ChooseDesignInstead, DoesNotDependOnThreads) {
  const ChosenDesign one = searched().choose(1);
  const ChosenDesign& two = choice();
  EXPECT_EQ(one.record.chosen, two.record.chosen);
  EXPECT_EQ(one.result.design.s, two.result.design.s);
  EXPECT_EQ(one.result.design.tasks[0].m, two.result.design.tasks[0].m);
  ASSERT_EQ(one.record.candidates.size(), two.record.candidates.size());
  for (std::size_t i = 0; i < one.record.candidates.size(); ++i) {
    EXPECT_EQ(one.record.candidates[i].name, two.record.candidates[i].name);
    EXPECT_EQ(one.record.candidates[i].F, two.record.candidates[i].F);
    EXPECT_EQ(one.record.candidates[i].played.line, two.record.candidates[i].played.line);
  }
}

TEST(ChooseDesign, PlaysAnOptimumThatPassesAndNothingElse) {
  const SearchedProblem searched(test::problem_of(
      "puppy", "[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\nvelocity = [0.1, 0.0]\n"));
  const ChosenDesign choice = searched.choose(1);
  EXPECT_EQ(choice.record.chosen, "optimum");
  EXPECT_TRUE(choice.record.pass);
  EXPECT_EQ(choice.record.candidates.size(), 1u);
  EXPECT_TRUE(choice.others.empty());
  EXPECT_EQ(choice.result.design.s, searched.found.winner().best.s);
}

/// Where nothing passes, the result is never farther from passing than the given body or the
/// optimum of F: all three are played to the end.
TEST(ChooseDesign, IsNeverFartherFromPassingThanTheGivenBody) {
  const SearchedProblem searched(test::problem_of(
      "quadruped", "[gait]\nname = \"trot\"\nperiod = 0.5\n[travel]\nvelocity = [0.9, 0.0]\n"));
  const ChosenDesign choice = searched.choose(2);
  EXPECT_FALSE(choice.record.pass);
  const double chosen = searched.candidate(choice, choice.record.chosen).played.merit;
  EXPECT_GT(chosen, 0.0);
  for (const char* name : {"optimum", "initial"})
    EXPECT_LE(chosen, searched.candidate(choice, name).played.merit) << name;
}

}  // namespace
}  // namespace legwright
