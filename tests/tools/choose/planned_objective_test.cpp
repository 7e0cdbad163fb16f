// SPDX-License-Identifier: Apache-2.0
// F of a candidate's plan is there while somebody holds it, and the same when it is built anew.
#include "tools/choose/planned_objective.hpp"

#include <gtest/gtest.h>

#include "optimizer/solve/first_motion.hpp"
#include "tests/tools/choose/problems.hpp"

namespace legwright {
namespace {

TEST(PlannedObjective, LivesAsLongAsItIsHeldAndIsTheSameAgain) {
  const CodesignProblem problem = test::trot();
  const Task& task = problem.objectives[0]->task();
  const PlannedObjective planned(problem.robot.morphology, problem.robot.space, task);
  EXPECT_EQ(planned.task().velocity, task.velocity);
  std::shared_ptr<const Objective> held = planned.get();
  EXPECT_EQ(planned.get(), held);
  const std::weak_ptr<const Objective> watch = held;
  const Eigen::VectorXd s = problem.robot.space.initial(), m = best_first_motion(*held, s);
  const std::vector<TermValue> first = held->terms(s, m);
  held.reset();
  EXPECT_TRUE(watch.expired()) << "nothing else keeps it";
  const std::vector<TermValue> again = planned.get()->terms(s, m);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_EQ(first[k].value, again[k].value);
}

}  // namespace
}  // namespace legwright
