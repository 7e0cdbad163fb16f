// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/nearest_word.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(NearestWord, IsOneThatMayBeMeant) {
  EXPECT_EQ(nearest("velocty", {"period", "velocity"}), "velocity");
  EXPECT_EQ(nearest("colour", {"period", "velocity"}), "");
}

TEST(SlipOf, TakesOneSlipOfAShortWordAndTwoOfALongOne) {
  EXPECT_EQ(slip_of("ryp", {"xyz", "rpy"}), "rpy") << "exchanged";
  EXPECT_EQ(slip_of("limt", {"limit"}), "limit") << "missing";
  EXPECT_EQ(slip_of("limiit", {"limit"}), "limit") << "too many";
  EXPECT_EQ(slip_of("Limit", {"limit"}), "limit") << "a capital";
  EXPECT_EQ(slip_of("lmt", {"limit"}), "") << "two of a short one";
  EXPECT_EQ(slip_of("multplyer", {"multiplier"}), "multiplier");
  EXPECT_EQ(slip_of("mltplyer", {"multiplier"}), "") << "three";
  EXPECT_EQ(slip_of("gazebo", {"limit", "mimic"}), "");
}

}  // namespace
}  // namespace legwright
