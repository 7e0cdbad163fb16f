// SPDX-License-Identifier: Apache-2.0
// What a change of the body did to a figure, and which figures are worth naming.
#include "optimizer/solve/effect.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(Effect, IsRelativeToWhatWasBefore) {
  const Effect less = effect_of(4.0, 3.0, Better::less);
  EXPECT_EQ(*less.change, -0.25);
  EXPECT_EQ(less.worse, 0.0);
  EXPECT_EQ(effect_of(4.0, 5.0, Better::less).worse, 0.25);
  EXPECT_EQ(effect_of(4.0, 3.0, Better::more).worse, 0.25);
  EXPECT_EQ(effect_of(4.0, 5.0, Better::more).worse, 0.0);
  EXPECT_EQ(effect_of(4.0, 5.0, Better::neither).worse, 0.0);
  EXPECT_EQ(*effect_of(-4.0, -5.0, Better::neither).change, -0.25);
}

TEST(Effect, NeedsBothSidesAndSomethingToCompareWith) {
  EXPECT_FALSE(effect_of(std::nullopt, 1.0, Better::less).change);
  EXPECT_FALSE(effect_of(1.0, std::nullopt, Better::less).change);
  EXPECT_FALSE(effect_of(0.0, 1.0, Better::less).change);
  EXPECT_EQ(effect_of(0.0, 1.0, Better::less).worse, 0.0);
}

TEST(Effect, FromOneSignToTheOtherIsNoRelativeChange) {
  EXPECT_FALSE(effect_of(-0.003, 0.98, Better::near_one).change);
  EXPECT_FALSE(effect_of(0.5, -0.5, Better::neither).change);
  EXPECT_EQ(*effect_of(0.05, 0.0, Better::less).change, -1.0) << "down to nothing is one";
  EXPECT_EQ(*effect_of(-0.05, 0.0, Better::neither).change, 1.0);
}

TEST(Effect, SmallWorseningsAreNone) {
  EXPECT_EQ(effect_of(0.001, 0.009, Better::less, 0.01).worse, 0.0);
  EXPECT_GT(effect_of(0.001, 0.02, Better::less, 0.01).worse, 0.0);
}

TEST(Effect, OfARatioCountsTheDistanceFromOne) {
  EXPECT_NEAR(effect_of(0.98, 0.90, Better::near_one).worse, 0.08, 1e-12);
  EXPECT_NEAR(effect_of(1.0, 1.07, Better::near_one).worse, 0.07, 1e-12) << "too fast is as bad";
  EXPECT_EQ(effect_of(0.98, 0.94, Better::near_one).worse, 0.0) << "below the threshold";
  EXPECT_EQ(effect_of(0.8, 1.0, Better::near_one).worse, 0.0);
  EXPECT_EQ(effect_of(0.98, 0.90, Better::near_one, 0.1).worse, 0.0);
}

TEST(MainEffects, AreAmountsThatFellAndTheWorst) {
  const std::vector<Effect> effects{{-0.3, 0.0}, {-0.04, 0.0}, {-0.5, 0.0},
                                    {0.2, 0.2},  {0.3, 0.3},   {0.04, 0.04}};
  const MainEffects main = main_effects(effects, {true, true, false, true, false, true});
  EXPECT_EQ(main.gains, (std::vector<std::size_t>{0}));
  ASSERT_TRUE(main.worst);
  EXPECT_EQ(*main.worst, 4U);
  const MainEffects none = main_effects({{0.04, 0.04}, {std::nullopt, 0.0}}, {true, true});
  EXPECT_TRUE(none.gains.empty());
  EXPECT_FALSE(none.worst);
}

}  // namespace
}  // namespace legwright
