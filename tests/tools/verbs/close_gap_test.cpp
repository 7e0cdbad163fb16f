// SPDX-License-Identifier: Apache-2.0
// Steps on a gait begin from what was chosen: its tightened plan, as the choice played it.
#include "tools/verbs/close_gap.hpp"

#include <gtest/gtest.h>

#include "tests/tools/choose/solved_motions.hpp"

namespace legwright {
namespace {

TEST(CloseGap, BeginsFromThePlanThatWasChosen) {
  const test::TemporaryFolder folder;
  const ResultFolder run = ResultFolder::create(folder.path() / "run", false);
  test::SolvedMotions solved(test::trot(), {Lever::narrow});
  solved.add({Tightening()});
  const Candidate& chosen = solved.designs.front();
  const auto played = [&](const Candidate& design) {
    return play_candidate(solved.problem, design, 1).trials.front();
  };
  const PlayedGait before = close_gap(run, solved.problem, chosen, 0, {}).before;
  EXPECT_EQ(before.line, played(chosen).line);
  EXPECT_EQ(before.merit, played(chosen).merit());
  EXPECT_NE(before.merit, played(solved.designs.back()).merit()) << "this shows nothing";
}

}  // namespace
}  // namespace legwright
