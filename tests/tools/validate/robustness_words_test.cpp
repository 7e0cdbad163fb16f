// SPDX-License-Identifier: Apache-2.0
// How margins are told to people.
#include <gtest/gtest.h>

#include "tools/validate/robustness_limits.hpp"

namespace legwright {
namespace {

/// The one line of a margin of the floor's friction, tested from 0.01 to 2.
std::string friction_line(std::optional<double> low, std::optional<double> low_fails,
                          std::optional<double> high, std::optional<double> high_fails) {
  Margin margin;
  margin.factor = disturbance_factors({}).front();
  margin.factor.tested_low = 0.01;
  margin.factor.tested_high = 2.0;
  margin.nominal = 0.8;
  margin.low = low;
  margin.low_fails = low_fails;
  margin.high = high;
  margin.high_fails = high_fails;
  Robustness robustness;
  robustness.margins = {margin};
  const std::string line = robustness_lines(robustness).front();
  return line.substr(line.find("survives"));
}

TEST(MarginWords, NameTheLastValueThatWalks) {
  EXPECT_EQ(friction_line(0.155, 0.13, {}, {}), "survives from 0.15 to 2 (tested)");
  EXPECT_EQ(friction_line({}, {}, 1.5, 1.6), "survives from 0.01 (tested) to 1.5");
  EXPECT_EQ(friction_line({}, {}, {}, {}), "survives from 0.01 to 2, all that was tested");
}

/// Halving towards an end that fails always stops short of it: that is no margin of the robot's.
TEST(MarginWords, SayWhereOnlyTheEndOfTheRangeFails) {
  EXPECT_EQ(friction_line(0.0115, 0.01, {}, {}),
            "survives from 0.011 (all tried but 0.01) to 2 (tested)");
  EXPECT_EQ(friction_line(0.0115, 0.01, 1.9, 2.0),
            "survives from 0.011 (all tried but 0.01) to 1.9 (all tried but 2)");
  EXPECT_EQ(friction_line(0.0115, 0.0105, {}, {}), "survives from 0.011 to 2 (tested)");  // twin
}

}  // namespace
}  // namespace legwright
