// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/task/problem.hpp"

namespace legwright::test {

/// The puppy with its hips turned outwards, so that it can do the task.
struct SolvedPuppy {
  CodesignProblem problem = read_problem(std::filesystem::path(test::source_dir()) / "examples" /
                                         "puppy" / "sideways.toml");
  const Objective& objective = *problem.objectives[0];
  Eigen::VectorXd s = problem.robot.space.initial(), m;

  SolvedPuppy() {
    s[6] = s[12] = 0.5;
    m = initial_guess(objective, s);
    const SolveReport report = newton(objective, s, m, {.tolerance = 1e-8, .max_iterations = 400});
    EXPECT_EQ(report.status, SolveStatus::converged);
  }
};

}  // namespace legwright::test
