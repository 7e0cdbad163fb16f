// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/limits.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/validate/limits_file.hpp"
#include "tools/validate/records.hpp"
#include "tools/validate/robustness_limits.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {
namespace {

const std::filesystem::path kExample =
    std::filesystem::path(test::source_dir()) / "examples/limits.toml";

std::string complaint(const std::string& text) {
  try {
    parse_limits(text, "my.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LimitsFile, ExampleSaysWhatHoldsAnyway) {
  const Limits read = read_limits(kExample), own = default_limits();
  ASSERT_EQ(read.size(), own.size());
  for (const auto& [name, bounds] : own) {
    ASSERT_TRUE(read.contains(name)) << name;
    EXPECT_EQ(read.at(name).low, bounds.low) << name;
    EXPECT_EQ(read.at(name).high, bounds.high) << name;
  }
  // The file states each of them; none is there by default only.
  const std::string text = read_file(kExample);
  for (const auto& [name, bounds] : own)
    EXPECT_NE(text.find("\n[" + name + "]"), std::string::npos) << name;
}

TEST(LimitsFile, ExampleKnowsEveryQuantity) {
  std::string all = read_file(kExample);  // what is commented out is an example of a limit
  for (const std::string start : {"[", "low", "high"})
    for (std::size_t at; (at = all.find("\n# " + start)) != std::string::npos;)
      all.erase(at + 1, 2);
  const Limits limits = parse_limits(all, kExample);
  for (const auto& quantity : limited_quantities())
    EXPECT_TRUE(limits.contains(quantity.name)) << quantity.name;
  for (const auto& name : robustness_limit_names()) EXPECT_TRUE(limits.contains(name)) << name;
  EXPECT_TRUE(need_robustness(limits));
  EXPECT_FALSE(need_robustness(default_limits()));
}

TEST(Limits, ATaskThatStepsOverSomethingAsksForIt) {
  EXPECT_FALSE(with_step_over(default_limits(), 0.0).contains("foot_clearance"));
  const Limits limits = with_step_over(default_limits(), 0.03);
  EXPECT_EQ(limits.at("foot_clearance").low, 0.03);
  const Limits own = with_step_over(parse_limits("foot_clearance.low = 0.02", "my.toml"), 0.03);
  EXPECT_EQ(own.at("foot_clearance").low, 0.02);
  Measurements run;
  run.cycles = 20;
  run.speed_ratio = 1.0;
  run.path_deviation = 0.0;
  for (const double clearance : {0.05, 0.029}) {
    FootMeasures foot;
    foot.swings = 4;
    foot.clearance_min = clearance;
    run.feet.push_back(foot);
  }
  const WantedMotion ahead{{0.1, 0.0}, 0.0};
  Verdict verdict = judge({run}, ahead, "walk", limits);
  EXPECT_FALSE(verdict.pass);
  EXPECT_NE(verdict.line.find("steps over no more than 0.029 m"), std::string::npos)
      << verdict.line;
  run.feet[1].clearance_min = 0.03;
  EXPECT_TRUE(judge({run}, ahead, "walk", limits).pass);
  run.feet.clear();  // nothing was seen to step: that is no pass
  EXPECT_FALSE(judge({run}, ahead, "walk", limits).pass);
}

TEST(LimitsFile, ReplacesOnlyWhatItSays) {
  const Limits limits = parse_limits("tilt.high = 0.05\nmargin.delay.high = 0.002\n", "my.toml");
  EXPECT_EQ(limits.at("tilt").high, 0.05);
  EXPECT_EQ(limits.at("speed_ratio").low, 0.95);
  EXPECT_EQ(limits.at("margin.delay").high, 0.002);
}

TEST(LimitsFile, FaultsAreToldWithLineKeyAndWayOut) {
  const std::string told = complaint(
      "[speed_ration]\nlow = 0.9\n[tilt]\nhihg = 0.1\n[slip]\nlow = 2\nhigh = 1\n[power]\n"
      "[margin.push]\nlow = 1\n[turn_ratio]\nlow = \"much\"\n");
  for (const char* part :
       {"my.toml:1: speed_ration: unknown key; did you mean 'speed_ratio'?",
        "my.toml:4: tilt.hihg: unknown key; did you mean 'tilt.high'?",
        "my.toml:7: slip.high: nothing would pass", "my.toml:8: power: has neither low nor high",
        "margin.push: unknown key", "my.toml:12: turn_ratio.low"})
    EXPECT_NE(told.find(part), std::string::npos) << part << "\n in\n" << told;
  EXPECT_NE(complaint("tilt = 0.1").find("expected a table"), std::string::npos);
  EXPECT_NE(complaint("[tilt").find("my.toml:1"), std::string::npos);
  EXPECT_THROW(read_limits("no/such.toml"), InputError);
}

TEST(LimitsFile, WhatCannotBePlayedIsRefusedWithItsRange) {
  for (const char* text :
       {"margin.floor_friction.low = 0", "margin.mass.low = -1", "margin.gains.high = 1e6",
        "margin.delay.high = 20", "margin.initial_roll.high = 1.6", "margin.slope_along.low = -2",
        "margin.push_left.low = -1e3", "survival.low = 90", "numerics.high = -1"}) {
    const std::string told = complaint(text),
                      key = std::string(text).substr(0, std::string(text).find(' '));
    EXPECT_NE(told.find("my.toml:1: " + key + ": is "), std::string::npos) << text << ": " << told;
    EXPECT_NE(told.find("; expected "), std::string::npos) << told;
  }
  EXPECT_NE(complaint("margin.delay.high = 20").find("expected 0 <= high <= 1 s"),
            std::string::npos);
  for (const auto& factor : disturbance_factors({})) {
    EXPECT_LE(factor.valid.first, factor.tested_low) << factor.name;
    EXPECT_GE(factor.valid.second, factor.tested_high) << factor.name;
    EXPECT_TRUE(!factor.by_ratio || factor.valid.first > 0.0) << factor.name;
  }
}

TEST(LimitsFile, LimitsOnTheWrongSideAreRefused) {
  /// On the second line of the file, each with its key.
  const auto expect_refused = [](const std::vector<std::string>& texts,
                                 const std::vector<std::string>& parts) {
    for (const std::string& text : texts) {
      const std::string told = complaint("# mine\n" + text), key = text.substr(0, text.find(' '));
      EXPECT_NE(told.find("my.toml:2: " + key + ": is "), std::string::npos) << text << told;
      for (const std::string& part : parts)
        EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
    }
  };
  expect_refused(
      {"tilt.high = -0.1", "power.low = -1", "saturated_share.high = 1.5", "self_contact.low = 2",
       "heading_drift_per_cycle.high = -0.01", "standing_speed.high = -1"},
      {"; expected 0 <= "});
  EXPECT_NE(complaint("[tilt]\nhigh = 0")
                .find("my.toml:2: tilt.high: nothing would pass: it must "
                      "stay below 0; expected more than 0"),
            std::string::npos)
      << complaint("[tilt]\nhigh = 0");
  EXPECT_EQ(complaint("missed_stances.high = 0"), "");
  EXPECT_EQ(complaint("slowest_cycle.low = -0.1\nfoot_clearance.low = -0.001"), "");
  expect_refused(
      {"margin.mass.low = 1.2", "margin.mass.high = 0.9", "margin.gains.low = 2",
       "margin.delay.low = 0.001", "margin.initial_roll.low = 0.05", "margin.push_left.high = -0.1",
       "margin.slope_along.high = -0.05", "margin.ground_sink.low = 0.001"},
      {" what is planned (", "to which the robot must walk; give one "});
  EXPECT_NE(complaint("margin.mass.low = 1.2")
                .find("is 1.2, above what is planned (1): low is a value down to which the robot "
                      "must walk; give one of at most 1, or call it high"),
            std::string::npos)
      << complaint("margin.mass.low = 1.2");
  EXPECT_EQ(complaint("margin.mass = { low = 1, high = 1 }\nmargin.delay.low = 0"), "");
}

TEST(LimitsFile, TheMarginOfFrictionIsComparedWithTheTasks) {
  const Limits limits = parse_limits("\nmargin.floor_friction.low = 0.7\n", "my.toml");
  EXPECT_NO_THROW(check_friction_margin(limits, "my.toml", 0.8));
  EXPECT_NO_THROW(check_friction_margin(default_limits(), "my.toml", 0.8));
  try {
    check_friction_margin(limits, "my.toml", 0.6);
    FAIL() << "walks at 0.6, and must at 0.7";
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what())
            .find("my.toml:2: margin.floor_friction.low: is 0.7, above what is planned (0.6)"),
        std::string::npos)
        << error.what();
  }
}

TEST(LimitsFile, WhatNothingCanPassWithTheDefaultsIsRefused) {
  EXPECT_NE(complaint("speed_ratio.low = 1.2")
                .find("my.toml:1: speed_ratio.low: nothing would "
                      "pass: low is 1.2, high 1.05, which holds by "
                      "default"),
            std::string::npos);
  EXPECT_NE(complaint("turn_ratio.high = 0.5").find("turn_ratio.high"), std::string::npos);
  EXPECT_NE(complaint("tilt.low = 0.1").find("tilt.low"), std::string::npos);  // below 0.1
  EXPECT_EQ(complaint("speed_ratio.low = 1.05"), "");
  EXPECT_EQ(complaint("speed_ratio = { low = 1.2, high = 1.3 }"), "");
}

TEST(LimitsFile, KnowsWhetherItAsksForOtherNumerics) {
  EXPECT_FALSE(ask_for_numerics(default_limits()));
  EXPECT_FALSE(ask_for_numerics(parse_limits("tilt.high = 0.05", "my.toml")));
  EXPECT_TRUE(ask_for_numerics(parse_limits("numerics.high = 0", "my.toml")));
}

TEST(JudgedLimits, UpperBoundThatDoesNotPassIsTold) {
  EXPECT_EQ(what_passes({0.0, 0.1}, "rad", Told::plain, true),
            "at least 0 and less than 0.1 rad passes");
  EXPECT_EQ(what_passes({0.0, 0.1}, "rad", Told::plain, false), "0 to 0.1 rad passes");
  Verdict verdict;
  verdict.limits = judge_limits({Measurements{}}, {{0.1, 0.0}, 0.0}, default_limits());
  const Json rows = json_of(verdict_record(verdict))["limits"];
  ASSERT_GE(rows.size(), 3U);
  for (const Json& row : rows)
    EXPECT_EQ(row.contains("strict"), row["name"] == "tilt" || row["name"] == "saturated_share")
        << row;
}

Measurements walk(double gain, double slip) {
  Measurements run;
  run.gain_scale = gain;
  run.cycles = 20;
  run.speed_ratio = 1.0;
  run.turn_ratio = 1.0;
  run.velocity = Eigen::Vector2d(0.1, 0.0);
  run.path_deviation = 0.0;
  run.feet.resize(2);
  run.feet[1].name = "right";
  run.feet[1].slip_max = slip;
  return run;
}

TEST(JudgedLimits, WorstValueAndItsPlaceAreTold) {
  Limits limits = default_limits();
  limits["slip"] = {{}, 0.02};
  const std::vector<Measurements> runs{walk(0.5, 0.01), walk(1.0, 0.03), walk(2.0, 0.025)};
  const auto rows = judge_limits(runs, {{0.1, 0.0}, 0.0}, limits);
  const auto slip =
      std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.name == "slip"; });
  ASSERT_NE(slip, rows.end());
  EXPECT_FALSE(slip->pass);
  EXPECT_EQ(slip->value, 0.03);
  EXPECT_EQ(slip->where, "default gains");
  EXPECT_EQ(slip->reason,
            "slips by 0.03 m at default and 0.025 m at double gains (up to 0.02 m passes; worst "
            "right)");
  const auto judged_slip = [](const auto& row) { return row.name == "slip"; };
  const auto by_default = judge_limits(runs, {{0.1, 0.0}, 0.0}, default_limits());
  EXPECT_EQ(std::count_if(by_default.begin(), by_default.end(), judged_slip), 0);
}

TEST(JudgedLimits, RadiusCountsOnACircleOnly) {
  auto run = walk(1.0, 0.0);
  run.speed_ratio = 1.04;
  run.turn_ratio = 0.96;  // each may pass, the circle is 8 % too wide
  const auto failing = [&](const WantedMotion& wanted) {
    std::string out;
    for (const auto& row : judge_limits({run}, wanted, default_limits()))
      if (!row.pass) out += row.name + " ";
    return out;
  };
  EXPECT_EQ(failing({{0.1, 0.0}, 0.3}), "radius_ratio ");
  EXPECT_EQ(failing({{0.1, 0.0}, 0.0}), "");
}

TEST(JudgedLimits, VerdictPassesWhenAllRowsDo) {
  auto runs = std::vector<Measurements>{walk(0.5, 0.0), walk(1.0, 0.0)};
  const WantedMotion wanted{{0.1, 0.0}, 0.0};
  const Verdict good = judge(runs, wanted, "walk");
  EXPECT_TRUE(good.pass);
  EXPECT_EQ(good.limits[0].name, "warnings");
  JudgedLimit survival;
  survival.name = "survival";
  survival.reason = "3 of 9 disturbed walks survive";
  const Verdict bad = judge(runs, wanted, "walk", default_limits(), {survival});
  EXPECT_FALSE(bad.pass);
  EXPECT_EQ(bad.line, "FAIL  walk forward at 0.100 m/s: 3 of 9 disturbed walks survive");
  for (auto& run : runs) run.fall = Fall{1.0, "the trunk sank"};
  const Verdict fallen = judge(runs, wanted, "walk");
  EXPECT_EQ(fallen.reasons.size(), 1U);  // though no other quantity could be measured
  for (const auto& row : fallen.limits) EXPECT_EQ(row.pass, row.name == "warnings") << row.name;
}

TEST(JudgedLimits, MarginsMustReachAsFarAsIsAsked) {
  Robustness robustness;
  for (const auto& factor : disturbance_factors({})) {
    Margin& margin = robustness.margins.emplace_back();
    margin.factor = factor;
    if (factor.name != "mass") continue;
    margin.low = 0.7;
    margin.low_cause = "falls after 1.00 s (the trunk sank)";
  }
  robustness.survival.samples = 10;
  robustness.survival.survived = 9;
  const auto judged = [&](const std::string& text) {
    return judge_robustness(robustness, parse_limits(text, "my.toml"));
  };
  EXPECT_TRUE(judged("margin.mass.low = 0.8").at(0).pass);
  EXPECT_TRUE(judged("margin.mass.high = 4").at(0).pass);  // as far as tested
  const auto row = judged("margin.mass.low = 0.6").at(0);
  EXPECT_FALSE(row.pass);
  EXPECT_EQ(row.name, "margin.mass.low");
  EXPECT_NE(row.reason.find("0.7, not 0.6 (falls after"), std::string::npos) << row.reason;
  EXPECT_TRUE(judged("survival.low = 0.9").at(0).pass);
  EXPECT_FALSE(judged("survival.low = 0.91").at(0).pass);
  robustness.margins.clear();
  robustness.nominal_cause = "falls";
  EXPECT_FALSE(judged("margin.mass.low = 0.9").at(0).pass);
  EXPECT_EQ(tested_for(parse_limits("margin.mass.high = 9", "my.toml")).at("mass").second, 9.0);
}

}  // namespace
}  // namespace legwright
