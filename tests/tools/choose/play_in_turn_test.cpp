// SPDX-License-Identifier: Apache-2.0
// Candidates played no further than needed, against the same played to the end each.
#include "tools/choose/play_in_turn.hpp"
#include "tests/support/long_tests.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/tools/choose/solved_motions.hpp"
#include "tools/simulate/rollout.hpp"

namespace legwright {
namespace {

/// Bodies of the quadruped that fail in both tasks, or in one.
class PlayInTurn : public testing::Test {
 protected:
  static const test::SolvedMotions& failing() {
    static const test::SolvedMotions all(
        read_problem(test::source_dir() + "/examples/quadruped/both.toml"),
        {Lever::margins, Lever::smooth_forces, Lever::narrow, Lever::wide, Lever::smooth_legs});
    return all;
  }
  static const std::vector<PlayedCandidate>& to_the_end() {
    static const std::vector<PlayedCandidate> played = [] {
      std::vector<PlayedCandidate> out;
      for (const Candidate& each : failing().designs)
        out.push_back(play_candidate(failing().problem, each, 1));
      return out;
    }();
    return played;
  }
};

TEST_F(PlayInTurn, TheNearestAreThoseOfWholePlaysToTheBit) {
  LEGWRIGHT_LONG_TEST();
  const std::vector<PlayedCandidate>& whole = to_the_end();
  std::vector<double> sorted;
  for (const PlayedCandidate& each : whole) {
    ASSERT_FALSE(each.pass) << "one that passes ends the play";
    sorted.push_back(each.distance);
  }
  std::sort(sorted.begin(), sorted.end());
  for (const std::size_t nearest : {0u, 1u, 5u}) {
    const PlayedInTurn in_turn = failing().play(nearest);
    ASSERT_EQ(in_turn.played.size(), whole.size());
    EXPECT_FALSE(in_turn.stopped);
    int saved = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const PlayedCandidate& ours = in_turn.played[i];
      EXPECT_FALSE(ours.pass);
      EXPECT_LE(ours.distance, whole[i].distance);
      EXPECT_LE(test::rollouts(ours), test::rollouts(whole[i]));
      saved += test::rollouts(whole[i]) - test::rollouts(ours);
      if (nearest > 0 && whole[i].distance <= sorted[nearest - 1]) {
        EXPECT_TRUE(ours.to_the_end);
      }
      if (!ours.to_the_end) {
        EXPECT_GT(ours.distance, 0.0);
        if (nearest > 0) {
          EXPECT_GE(ours.distance, sorted[nearest - 1]) << "it may be nearer";
        }
        continue;
      }
      EXPECT_EQ(ours.distance, whole[i].distance);
      EXPECT_EQ(ours.line, whole[i].line);
      for (std::size_t k = 0; k < ours.trials.size(); ++k) {
        EXPECT_EQ(ours.trials[k].speed_ratio, whole[i].trials[k].speed_ratio);
        EXPECT_EQ(ours.trials[k].residual, whole[i].trials[k].residual);
      }
    }
    if (nearest == 0) {
      EXPECT_GT(saved, 0) << "then it is of no use";
    }
  }
}

TEST_F(PlayInTurn, ThreadsAndTheOrderOfGainsChangeNothing) {
  const PlayedInTurn one = failing().play(2);
  const PlayedInTurn three = failing().play(2, 3);
  ASSERT_EQ(one.played.size(), three.played.size());
  for (std::size_t i = 0; i < one.played.size(); ++i) {
    EXPECT_EQ(one.played[i].distance, three.played[i].distance);
    EXPECT_EQ(one.played[i].line, three.played[i].line);
    EXPECT_EQ(test::rollouts(one.played[i]), test::rollouts(three.played[i]));
  }
  const PlayedInTurn ordered = failing().play(failing().designs.size(), 1, &to_the_end().front());
  for (std::size_t i = 0; i < ordered.played.size(); ++i)
    EXPECT_EQ(ordered.played[i].distance, to_the_end()[i].distance);
}

TEST_F(PlayInTurn, WhoeverStopsItGetsWhatWasPlayed) {
  int asked = 0;
  const PlayedInTurn stopped = failing().play(2, 1, nullptr, [&] { return ++asked > 20; });
  EXPECT_TRUE(stopped.stopped);
  EXPECT_LT(stopped.played.size(), failing().designs.size());
}

/// The first that passes is the last that is played, for as long as play_candidate() plays it; who
/// cannot be played before it is infinitely far from passing.
TEST(PlayInTurnOfOneTask, EndsWithTheFirstThatPasses) {
  test::SolvedMotions all(test::trot(), {Lever::margins});
  const Candidate passing = all.designs.front();
  Candidate broken = passing, failing = all.guess;
  broken.design.tasks[0].m.setConstant(std::numeric_limits<double>::quiet_NaN());
  all.designs = {broken, failing, passing, failing};
  const PlayedInTurn played = all.play(2);
  ASSERT_EQ(played.played.size(), 3u) << played.played.back().line;
  EXPECT_FALSE(played.played[0].pass);
  EXPECT_EQ(played.played[0].distance, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(played.played[0].line.empty());
  EXPECT_FALSE(played.played[1].pass);
  EXPECT_FALSE(played.played[1].to_the_end) << "nobody asks how far it is from passing";
  EXPECT_EQ(test::rollouts(played.played[1]), 1);
  const PlayedCandidate whole = play_candidate(all.problem, passing, 1);
  ASSERT_TRUE(whole.pass);
  EXPECT_EQ(played.played[2].line, whole.line);
  EXPECT_EQ(test::rollouts(played.played[2]), test::rollouts(whole));
}

}  // namespace
}  // namespace legwright
