// SPDX-License-Identifier: Apache-2.0
// Sums over masses that grow with the design, against sums by hand.
#include "optimizer/design/growth.hpp"

#include <gtest/gtest.h>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// Three masses on two links: one that keeps its mass, one that grows with s₀, one with s₀ and s₂.
Morphology make_robot() {
  Morphology robot;
  robot.links.resize(2);
  robot.links[0].masses.push_back({2.0, {}});
  robot.links[0].masses.push_back({0.5, {}, {{0, 0.1}}, 5e-4});
  robot.links[1].masses.push_back({0.3, {}, {{2, 0.4}, {0, 0.1}}, 2e-4});
  return robot;
}

TEST(Growth, MassByHand) {
  const Morphology robot = make_robot();
  EXPECT_EQ(growth_parameters(robot), (std::vector<int>{0, 2}));
  const VectorXd initial = (VectorXd(3) << 0.1, 7.0, 0.4).finished();
  EXPECT_NEAR(growth_sum(robot, Amount::mass, initial).value, 2.8, 1e-15);
  // s₀ twice and s₂ three times as long: 2 + 0.5 · 2 + 0.3 · 2 · 3.
  const VectorXd s = (VectorXd(3) << 0.2, -1.0, 1.2).finished();
  const GrowthSum sum = growth_sum(robot, Amount::mass, s);
  EXPECT_NEAR(sum.value, 2.0 + 1.0 + 1.8, 1e-14);
  ASSERT_EQ(sum.gradient.size(), 2);
  EXPECT_NEAR(sum.gradient[0], 0.5 / 0.1 + 0.3 * 3.0 / 0.1, 1e-13);
  EXPECT_NEAR(sum.gradient[1], 0.3 * 2.0 / 0.4, 1e-13);
  EXPECT_EQ(sum.hessian(0, 0), 0.0) << "linear in each length alone";
  EXPECT_EQ(sum.hessian(1, 1), 0.0);
  EXPECT_NEAR(sum.hessian(0, 1), 0.3 / (0.1 * 0.4), 1e-13);
  EXPECT_EQ(sum.hessian(1, 0), sum.hessian(0, 1));
}

TEST(Growth, VolumeCountsPrintedPartsOnly) {
  const Morphology robot = make_robot();
  const VectorXd s = (VectorXd(3) << 0.2, 0.0, 1.2).finished();
  const GrowthSum sum = growth_sum(robot, Amount::printed_volume, s);
  EXPECT_NEAR(sum.value, 5e-4 * 2.0 + 2e-4 * 2.0 * 3.0, 1e-18);
  EXPECT_NEAR(sum.gradient[1], 2e-4 * 2.0 / 0.4, 1e-17);
}

TEST(Growth, OfARobotThatDoesNotGrowIsItsMass) {
  const test::Puppy puppy = test::make_puppy(true);
  EXPECT_TRUE(growth_parameters(puppy.morphology).empty());
  const GrowthSum sum = growth_sum(puppy.morphology, Amount::mass, puppy.space.initial());
  EXPECT_NEAR(sum.value, puppy.morphology.total_mass(), 1e-12);
  EXPECT_EQ(sum.gradient.size(), 0);
  EXPECT_EQ(growth_sum(puppy.morphology, Amount::printed_volume, puppy.space.initial()).value, 0.0);
}

TEST(Growth, DerivativesOfThePrintedPuppyMatchDifferences) {
  test::Puppy puppy = test::make_puppy(true);
  test::print_bodies(puppy);
  const std::vector<int> parameters = growth_parameters(puppy.morphology);
  EXPECT_EQ(parameters.back(), puppy.space.find("body_length"));
  const VectorXd s = 1.07 * puppy.space.initial();
  const double h = 1e-6;
  for (const Amount amount : {Amount::mass, Amount::printed_volume}) {
    const GrowthSum at = growth_sum(puppy.morphology, amount, s);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      VectorXd up = s, down = s;
      up[parameters[k]] += h;
      down[parameters[k]] -= h;
      const GrowthSum above = growth_sum(puppy.morphology, amount, up),
                      below = growth_sum(puppy.morphology, amount, down);
      EXPECT_NEAR((above.value - below.value) / (2 * h), at.gradient[column], 1e-7);
      EXPECT_LT(((above.gradient - below.gradient) / (2 * h) - at.hessian.col(column)).norm(),
                1e-6 * (1.0 + at.hessian.norm()));
    }
  }
}

}  // namespace
}  // namespace legwright
