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
  EXPECT_FALSE(pace.must_end(now - 1ms, 0ms));
  pace.move(now);
  EXPECT_LE(pace.due(), now) << "overdue";
  EXPECT_TRUE(pace.must_end(now, DragPace::kShort - 1ms));
  EXPECT_FALSE(pace.must_end(now, DragPace::kShort)) << "too long for the hand to wait";
  pace.end();
  pace.move(now);  // the next step of the same hand, whether it interrupted the solve or not
  EXPECT_EQ(pace.due(), now + DragPace::kRest);
}

}  // namespace
}  // namespace legwright
