// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/carried_design.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "tests/support/paths.hpp"
#include "tools/studio/opening.hpp"

namespace legwright {
namespace {

const std::string kName = "front_thigh_length";

Opening puppy() {
  const std::filesystem::path folder = test::source_dir() + "/examples/puppy";
  return open_path(folder / "sideways.toml", AllowedPaths({folder}, {test::source_dir()}));
}

std::vector<session::Bounds> bounds_of(const Opening& opening) {
  std::vector<session::Bounds> out;
  for (const SessionCommand& command : opening.commands)
    if (const auto* bounds = std::get_if<session::Bounds>(&command)) out.push_back(*bounds);
  return out;
}

TEST(CarriedDesign, BoundsAreNarrowedAsFarAsTheRobotsLetThem) {
  Opening opening = puppy();
  const DesignSpace space = check_fit(opening);
  const DesignParameter& thigh = space.parameters[static_cast<std::size_t>(space.find(kName))];
  CarriedDesign carried;
  carried.bounds[kName] = {thigh.lower - 1.0, thigh.initial + 0.001};
  EXPECT_EQ(carry_over(carried, opening), "Bounds as before: " + kName + ".");
  const std::vector<session::Bounds> taken = bounds_of(opening);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].lower, thigh.lower);
  EXPECT_EQ(taken[0].upper, thigh.initial + 0.001);
}

/// Else the one value of its end would be all that is left, and be called the bounds of before.
TEST(CarriedDesign, BoundsBeyondThoseOfTheRobotAreNotTakenOver) {
  Opening opening = puppy();
  const DesignSpace space = check_fit(opening);
  const DesignParameter& thigh = space.parameters[static_cast<std::size_t>(space.find(kName))];
  CarriedDesign carried;
  carried.values[kName] = thigh.upper + 0.015;
  carried.bounds[kName] = {thigh.upper + 0.01, thigh.upper + 0.02};
  EXPECT_EQ(carry_over(carried, opening),
            "Values of before: " + kName + ". At their new bounds: " + kName +
                ". Bounds of before that lie beyond those of this robot: " + kName + ".");
  EXPECT_TRUE(bounds_of(opening).empty());
}

}  // namespace
}  // namespace legwright
