// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/faced_frame.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

using Eigen::Vector2d;

TEST(FacingText, IsAnAxisWithItsSign) {
  for (const char* text : {"+x", "-x", "+y", "-y"})
    EXPECT_EQ(facing_text(*facing_axis(text)), text);
  for (const char* text : {"", "x", "+z", "+X", "+xy", "--x"})
    EXPECT_FALSE(facing_axis(text)) << text;
}

TEST(Facing, TurnsWhatIsAheadAndToTheLeft) {
  EXPECT_EQ(from_facing({2, 1}, {1, 0}), Vector2d(2, 1));
  EXPECT_EQ(from_facing({2, 1}, {0, 1}), Vector2d(-1, 2));
  EXPECT_EQ(from_facing({2, 1}, {-1, 0}), Vector2d(-2, -1));
  EXPECT_EQ(from_facing({2, 1}, {0, -1}), Vector2d(1, -2));
  for (const char* text : {"+x", "-x", "+y", "-y"})
    EXPECT_EQ(as_faced(from_facing({2, 1}, *facing_axis(text)), *facing_axis(text)),
              Vector2d(2, 1));
}

TEST(Facing, OrdersFeetFromItsOwnFrontToHind) {
  // Places of a robot that faces +x: front left, front right, hind left, hind right.
  const std::vector<Eigen::Vector3d> feet{{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}};
  EXPECT_EQ(order_as_faced(feet, {1, 0}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(order_as_faced(feet, {-1, 0}), (std::vector<int>{3, 2, 1, 0}));
  EXPECT_EQ(order_as_faced(feet, {0, 1}), (std::vector<int>{2, 0, 3, 1}));
}

}  // namespace
}  // namespace legwright
