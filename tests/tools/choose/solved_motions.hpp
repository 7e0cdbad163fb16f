// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/tools/choose/problems.hpp"
#include "tools/choose/play_in_turn.hpp"
#include "tools/choose/tightened_search.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright::test {

/// The given body of a problem, its motions solved once for each of some tightenings.
class SolvedMotions {
 public:
  SolvedMotions(CodesignProblem p, const std::vector<Lever>& levers)
      : problem(std::move(p)), costs_(problem) {
    load_gait_plugin();
    guess.design.s = problem.robot.space.initial();
    for (const JointTask& task : costs_.tasks())
      guess.design.tasks.emplace_back().m = task.guess(guess.design.s);
    for (const Lever lever : levers) {
      const auto tasks = static_cast<std::size_t>(problem.task_count());
      add(std::vector<Tightening>(tasks, Tightening().with(lever, {})));
    }
  }
  void add(const std::vector<Tightening>& tightening) {
    CodesignOptions options;
    options.near_optimum = options.motion_only = true;
    auto found =
        search_tightened(problem, costs_.tasks(), guess, tightening, problem.robot.space, options);
    ASSERT_TRUE(found);
    designs.push_back(std::move(*found));
  }
  PlayedInTurn play(std::size_t nearest, int threads = 1, const PlayedCandidate* like = nullptr,
                    const std::function<bool()>& stop = {}) const {
    std::vector<CandidateInTurn> turns;
    for (const Candidate& each : designs) turns.push_back({&each, like});
    return play_in_turn(problem, turns, nearest, threads, stop);
  }

  CodesignProblem problem;
  Candidate guess{"guess", {}, {}, {}};
  std::vector<Candidate> designs;

 private:
  ProblemCosts costs_;
};

inline int rollouts(const PlayedCandidate& played) {
  int sum = 0;
  for (const GaitTrial& trial : played.trials) sum += trial.rollouts;
  return sum;
}

}  // namespace legwright::test
