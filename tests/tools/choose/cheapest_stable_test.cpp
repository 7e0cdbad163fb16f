// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/cheapest_stable.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace legwright {
namespace {

/// Whose multipliers were asked for, in that order.
struct Asked {
  std::vector<double> multipliers;
  std::vector<std::size_t> of = {};

  std::function<double(std::size_t)> ask() {
    return [this](std::size_t i) {
      of.push_back(i);
      return multipliers.at(i);
    };
  }
};

const std::vector<PlayedCost> kPlayed{{true, 1.05}, {false, 1.01}, {true, 1.0}, {true, 1.2}};

TEST(CheapestStable, IsBetterThanACheaperOneThatIsNot) {
  Asked asked{{0.4, 0.1, 1.3, 0.1}};
  EXPECT_EQ(cheapest_stable(kPlayed, 1.0, asked.ask()), 0U);
  EXPECT_EQ(asked.of, (std::vector<std::size_t>{2, 0})) << "not what fails, nor what is too dear";
}

TEST(CheapestStable, IsTheCheapestWhereThatIsStable) {
  Asked asked{{0.4, 0.1, 0.9, 0.1}};
  EXPECT_EQ(cheapest_stable(kPlayed, 1.0, asked.ask()), 2U);
  EXPECT_EQ(asked.of, (std::vector<std::size_t>{2}));
}

TEST(CheapestStable, IsNoneWhereNoneComesBackToItsCycle) {
  Asked asked{{1.0, 0.1, std::numeric_limits<double>::infinity(), 0.1}};
  EXPECT_EQ(cheapest_stable(kPlayed, 1.0, asked.ask()), std::nullopt);
}

TEST(CheapestStable, AsksNothingWhereThereIsNoChoice) {
  Asked asked{{0.4, 0.1, 0.9, 0.1}};
  EXPECT_EQ(cheapest_stable({{true, 1.0}, {false, 1.0}}, 1.0, asked.ask()), std::nullopt);
  EXPECT_TRUE(asked.of.empty());
}

}  // namespace
}  // namespace legwright
