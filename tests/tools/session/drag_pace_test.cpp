// SPDX-License-Identifier: Apache-2.0
#include "tools/session/drag_pace.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

using namespace std::chrono_literals;

TEST(DragPaceTest, SolvesOnceTheHandRests) {
  const auto start = DragPace::Clock::now();
  DragPace pace;
  EXPECT_LE(pace.due(), start) << "no hand moves the body";
  for (const auto step : {0ms, 30ms, 60ms}) {
    pace.move(start + step);
    EXPECT_EQ(pace.due(), start + step + DragPace::kRest);
  }
}

TEST(DragPaceTest, SolvesEverySoOftenWhileTheHandMoves) {
  const auto start = DragPace::Clock::now();
  DragPace pace;
  auto now = start;
  for (; now < start + DragPace::kLongest; now += 10ms) {
    pace.move(now);
    EXPECT_GT(pace.due(), now);
  }
  EXPECT_FALSE(pace.must_end(now - 1ms));
  pace.move(now);
  EXPECT_LE(pace.due(), now) << "overdue";
  EXPECT_TRUE(pace.must_end(now));
  pace.end();
  pace.move(now);  // the next step of the same hand, whether it interrupted the solve or not
  EXPECT_EQ(pace.due(), now + DragPace::kRest);
}

TEST(DragPaceTest, SolvesTakeASmallShareOfADrag) {
  const auto start = DragPace::Clock::now();
  const auto took = DragPace::kShort - 1ms;
  DragPace pace;
  pace.solved(took);
  pace.move(start);
  EXPECT_FALSE(pace.must_end(start + DragPace::kLongest));
  EXPECT_FALSE(pace.must_end(start + DragPace::kRarely * took - 1ms));
  EXPECT_TRUE(pace.must_end(start + DragPace::kRarely * took));
  pace.solved(DragPace::kShort);
  EXPECT_FALSE(pace.must_end(start + 10 * DragPace::kLongest)) << "too long for the hand to wait";
}

}  // namespace
}  // namespace legwright
