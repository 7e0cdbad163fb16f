// SPDX-License-Identifier: Apache-2.0
// The baseline of co-design: the best motion of the body as it is, not the first that is found.
#include "optimizer/solve/first_motion.hpp"

#include <gtest/gtest.h>

#include "optimizer/solve/codesign.hpp"
#include "tests/tools/choose/problems.hpp"

namespace legwright {
namespace {

/// F of the body as it is, from a first motion.
double motion_only(const CodesignProblem& problem, const Eigen::VectorXd& start) {
  ObjectiveCost cost(*problem.objectives[0]);
  WeightedCost task;
  task.cost = &cost;
  task.initial_motion = start;
  CodesignOptions options;
  options.motion_only = true;
  return codesign({task}, problem.robot.space, problem.robot.space.initial(), options).best.value;
}

TEST(BestFirstMotion, LeavesABadGuess) {
  // At 0.4 m/s the hexapod's guess leads to legs that collide, F 17.7; from a slower walk, or from
  // standing, its body does it with an eighth of that.
  const CodesignProblem problem = test::problem_of(
      "hexapod",
      "[gait]\nname = \"tripod\"\nperiod = 0.6\nknots = 20\n[travel]\nvelocity = [0.4, 0.0]\n"
      "[limits]\nmin_normal = 0.03\nswing_height = 0.02\nclearance = 0.024\n"
      "[weights]\nstyle_foot = 0.03\nsmoothness = 0.33\n");
  const Objective& objective = *problem.objectives[0];
  const Eigen::VectorXd s = problem.robot.space.initial();
  const double guess = motion_only(problem, initial_guess(objective, s)),
               best = motion_only(problem, best_first_motion(objective, s));
  EXPECT_GT(guess, 10.0);
  EXPECT_LT(best, 3.0);
}

TEST(BestFirstMotion, KeepsAGoodGuess) {
  const CodesignProblem problem = test::problem_of(
      "puppy", "[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\nvelocity = [0.1, 0.0]\n");
  const Objective& objective = *problem.objectives[0];
  const Eigen::VectorXd s = problem.robot.space.initial();
  EXPECT_EQ(best_first_motion(objective, s), initial_guess(objective, s));
}

TEST(BestFirstMotion, PerturbsBySeedAndNeverEndsHigher) {
  const CodesignProblem problem = test::trot();
  const Objective& objective = *problem.objectives[0];
  const Eigen::VectorXd s = problem.robot.space.initial();
  const Eigen::VectorXd plain = best_first_motion(objective, s),
                        more = best_first_motion(objective, s, {4, 1});
  FirstMotionOptions side_by_side{4, 1};
  side_by_side.threads = 3;
  EXPECT_EQ(more, best_first_motion(objective, s, side_by_side));
  EXPECT_LE(motion_only(problem, more), motion_only(problem, plain) * (1.0 + 1e-3));
}

}  // namespace
}  // namespace legwright
