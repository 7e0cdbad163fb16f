// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/cycle_target.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(CycleTarget, WithoutPhasesItsValuesAreEvenlySpaced) {
  const CycleTarget target{{}, {1.0, 3.0, 2.0, 7.0}, 1.0};
  for (const double phase : {0.0, 0.1, 0.25, 0.8, 1.3})
    EXPECT_EQ(target.at(phase), over_cycle(target.values, phase)) << phase;
}

TEST(CycleTarget, IsStraightBetweenItsPhasesAndOverTheEndOfTheCycle) {
  const CycleTarget target{{0.2, 0.6}, {1.0, 3.0}, 1.0};
  EXPECT_NEAR(target.at(0.2), 1.0, 1e-12);
  EXPECT_NEAR(target.at(0.6), 3.0, 1e-12);
  EXPECT_NEAR(target.at(0.4), 2.0, 1e-12);
  EXPECT_NEAR(target.at(0.9), 2.0, 1e-12) << "half of the way to phase 0.2 of the next cycle";
  EXPECT_NEAR(target.at(0.0), 5.0 / 3.0, 1e-12);
  EXPECT_NEAR(target.at(1.4), 2.0, 1e-12);
  EXPECT_NEAR(target.at(-0.6), 2.0, 1e-12);
}

TEST(CycleTarget, OneValueHoldsAlways) {
  for (const CycleTarget& target : {CycleTarget{{}, {4.0}, 1.0}, CycleTarget{{0.0}, {4.0}, 1.0},
                                    CycleTarget{{0.5}, {4.0}, 1.0}})
    for (const double phase : {0.0, 0.25, 0.5, 0.99}) EXPECT_EQ(target.at(phase), 4.0) << phase;
}

TEST(CycleTarget, IsGivenWithValuesThatWeighSomething) {
  const std::vector<CycleTarget> targets{{}, {{}, {1.0}, 0.0}, {{}, {1.0}, 0.5}};
  EXPECT_EQ(target_of(targets, 0), nullptr);
  EXPECT_EQ(target_of(targets, 1), nullptr);
  EXPECT_EQ(target_of(targets, 2), &targets[2]);
  EXPECT_EQ(target_of(targets, 3), nullptr) << "a robot without targets";
}

}  // namespace
}  // namespace legwright
