// SPDX-License-Identifier: Apache-2.0
// A gait that takes up a good part of what it may stray is asked one run more, and its next aim
// makes up for what it loses in other numerics, too.
#include <gtest/gtest.h>

#include "tests/tools/choose/solved_motions.hpp"
#include "tools/choose/physics_trial.hpp"
#include "tools/run/design_folder.hpp"

namespace legwright {
namespace {

/// A walk straight ahead, judged as one that goes so much to its left as well [m/s].
class WanderingGait : public testing::Test {
 protected:
  static const test::SolvedMotions& motions() {
    static const test::SolvedMotions all = [] {
      test::SolvedMotions out(test::problem_of("puppy",
                                               "[gait]\nname = \"walk\"\nperiod = 1.0\n"
                                               "[travel]\nvelocity = [0.1, 0.0]\n"),
                              {});
      out.add({Tightening{}});
      return out;
    }();
    return all;
  }
  GaitOnTrial on_trial(double to_its_left) {
    const CodesignProblem& problem = motions().problem;
    const Candidate& candidate = motions().designs.front();
    wanted_ = problem.task(0);
    wanted_.velocity.y() = to_its_left;
    return GaitOnTrial(problem.robot, wanted_,
                       design_texts(problem.robot, *candidate.objective(problem, 0),
                                    candidate.design.s, candidate.design.tasks[0].m));
  }

 private:
  TaskFile wanted_;
};

TEST_F(WanderingGait, IsAskedOneRunMore) {
  std::vector<int> asked;
  for (const double to_its_left : {0.0, 0.005}) {  // astray by none, and by 5 % of the way
    GaitOnTrial gait = on_trial(to_its_left);
    GaitTrial trial = gait.play(PlayedCycles::all);
    ASSERT_TRUE(trial.pass) << trial.line;
    const int before = trial.rollouts;
    gait.ask_other_numerics(1, trial);
    EXPECT_TRUE(trial.pass) << trial.line;
    asked.push_back(trial.rollouts - before);
  }
  EXPECT_EQ(asked, (std::vector<int>{3, 4}));
}

TEST_F(WanderingGait, AimsForWhatItLosesInOtherNumericsToo) {
  GaitOnTrial gait = on_trial(0.0);
  GaitTrial trial = gait.play(PlayedCycles::all);
  const double drift = trial.heading_drift, speed = trial.speed_ratio;
  gait.ask_other_numerics(1, trial);
  EXPECT_NE(trial.heading_drift, drift);
  EXPECT_NE(trial.speed_ratio, speed);
  EXPECT_NEAR(trial.heading_drift, drift, 1e-3);
  EXPECT_NEAR(trial.speed_ratio, speed, 0.02);
}

}  // namespace
}  // namespace legwright
