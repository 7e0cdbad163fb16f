// SPDX-License-Identifier: Apache-2.0
#include "tools/report/words.hpp"

#include <gtest/gtest.h>

#include "tools/report/judged_words.hpp"

namespace legwright {
namespace {

TEST(ShortNumber, KeepsThreeDigits) {
  EXPECT_EQ(short_number(0.0), "0");
  EXPECT_EQ(short_number(1249.3), "1249");
  EXPECT_EQ(short_number(9.7249), "9.72");
  EXPECT_EQ(short_number(0.09876), "0.0988");
  EXPECT_EQ(short_number(-0.5), "−0.5");
  EXPECT_EQ(short_number(2.34e-7), "2.3 × 10⁻⁷");
  EXPECT_EQ(short_number(4.5e12), "4.5 × 10¹²");
  EXPECT_EQ(short_number(std::nullopt), "–");
}

TEST(WithDegrees, TurnsAnglesAndNothingElse) {
  EXPECT_EQ(with_degrees("tilt 0.01 rad, no fall"), "tilt 0.6° (0.01 rad), no fall");
  EXPECT_EQ(with_degrees("(tilted by more than 1 rad)"), "(tilted by more than 57.3° (1 rad))");
  EXPECT_EQ(with_degrees("0.5 rad and 1 rad"), "28.6° (0.5 rad) and 57.3° (1 rad)");
  for (const char* other : {"0.1 rad/s", "a rad", " rad", "", "1.2.3 rad", "2 radii"})
    EXPECT_EQ(with_degrees(other), other);
  EXPECT_EQ(verdict_details("PASS  walk: tilt 0.01 rad"), "tilt 0.6° (0.01 rad)");
}

TEST(MeasuredWords, DifferFromABoundThatIsMissed) {
  LimitRow row;
  row.name = "saturated_share";
  row.unit = "1";
  row.high = 0.001;
  row.value = 0.00104;
  row.pass = false;
  EXPECT_EQ(measured_words(row), "0.104 %");
  EXPECT_EQ(bound_words(row), "at most 0.1 %");
  row.value = 0.0314;  // twin: told apart anyway
  EXPECT_EQ(measured_words(row), "3.1 %");
  row.value = row.high;  // a strict bound is missed by nothing
  row.strict = true;
  EXPECT_EQ(measured_words(row), bound_words(row).substr(std::string("less than ").size()));
  row.name = "tilt_max";
  row.unit = "rad";
  row.high = 0.35;
  row.value = 0.3501;
  EXPECT_EQ(measured_words(row), "20.06°");
}

TEST(Numbers, HaveTheDigitsTheirPlaceNeeds) {
  EXPECT_EQ(three_digits(6.0), "6.00");
  EXPECT_EQ(three_digits(-87.15), "−87.2");
  EXPECT_EQ(long_number(-13.341285753357385), "−13.34129");
  EXPECT_EQ(long_number(2.709627378986372e-05), "2.709627 × 10⁻⁵");
  EXPECT_EQ(quantity_words(0.000219, "m"), "0.219 mm");
  EXPECT_EQ(quantity_words(1e-7, "m"), "below 0.001 mm");
  EXPECT_EQ(quantity_words(-1.0, "rad"), "−57.3°");
  EXPECT_EQ(quantity_words(0.1234, "N m"), "0.123 N·m");
  EXPECT_EQ(quantity_words(0.5, ""), "0.5");
}

TEST(TaskWords, TellTheWayAndThePace) {
  RunRecord run;
  EXPECT_EQ(task_words(run), "");
  run.task.emplace();
  run.task->gait = "trot";
  run.task->velocity = {0.0, -0.1};
  run.task->period = 0.4;
  EXPECT_EQ(task_words(run), "trot, 0.1 m/s to the right, 0.4 s per cycle");
  run.task->step_over = 0.03;
  run.task->slope = {0.1, 0.0};
  EXPECT_EQ(
      task_words(run),
      "trot, 0.1 m/s to the right, up a slope of 5.73°, stepping over 30 mm, 0.4 s per cycle");
  run.task->dynamics = "constant_inertia";
  EXPECT_EQ(task_words(run),
            "trot, 0.1 m/s to the right, up a slope of 5.73°, stepping over 30 mm, planned with "
            "constant inertia, 0.4 s per cycle");
}

TEST(Times, AreEarlyOrLate) {
  EXPECT_EQ(early_or_late(-0.017), "17 ms early");
  EXPECT_EQ(early_or_late(0.0042), "4.2 ms late");
  EXPECT_EQ(early_or_late(1e-12), "on time");
  EXPECT_EQ(early_or_late(-0.0), "on time");
  EXPECT_EQ(early_or_late(std::nullopt), "–");
}

TEST(Parameters, ShowPeopleTheirUnitsAndBounds) {
  RunRecord run;
  run.parameters = {{"a", "rad", "axis_angle", "", 0.0, -1.4, 1.4, 1.4, 1},
                    {"b", "m", "length", "", 0.06, 0.03, 0.09, 0.05, 1}};
  const auto views = parameters_of(run);
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[0].change(), "+80.2°");
  EXPECT_EQ(views[0].at_bound(), "upper bound");
  EXPECT_EQ(views[1].change(), "−10.0 mm");
  EXPECT_EQ(views[1].at_bound(), "");
}

}  // namespace
}  // namespace legwright
