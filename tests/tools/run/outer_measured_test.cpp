// SPDX-License-Identifier: Apache-2.0
#include "tools/run/outer_measured.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

GainMetrics walked() {
  GainMetrics metrics;
  metrics.seconds = 10.0;
  metrics.cycles = 20;
  metrics.power_mean = 3.0;
  metrics.joints = {{"a", 0.0, 1.5, 3.0, 0.0, 0.0}, {"b", 0.0, 2.5, 3.0, 0.0, 0.0}};
  return metrics;
}

TEST(OuterMeasured, IsTheLargestTorqueAndTheWorkOfACycle) {
  EXPECT_DOUBLE_EQ(measured_amount("peak_torque", walked()).value(), 2.5);
  EXPECT_DOUBLE_EQ(measured_amount("mechanical_work", walked()).value(), 1.5);
  EXPECT_FALSE(measured_amount("printed_volume", walked()));
}

TEST(OuterMeasured, LeavesOutGainsAtWhichItFell) {
  MetricsRecord metrics;
  for (const char* gain : {"half", "double"}) metrics.initial.of(gain) = walked();
  metrics.initial.of("half").fall.emplace();
  metrics.result.of("half") = walked();
  OuterRecord outer;
  outer.objective = "peak_torque";
  const auto found = outer_measured(outer, metrics);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->initial.size(), 1u);
  EXPECT_EQ(found->initial[0].first, "double");
  EXPECT_EQ(found->result.size(), 1u);
  outer.source = "Python: peak_torque";  // another quantity that has that name
  EXPECT_FALSE(outer_measured(outer, metrics));
  outer = {};
  outer.objective = "printed_volume";
  EXPECT_FALSE(outer_measured(outer, metrics));
}

}  // namespace
}  // namespace legwright
