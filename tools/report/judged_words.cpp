// SPDX-License-Identifier: Apache-2.0
#include "tools/report/judged_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "tools/report/number_words.hpp"
#include "tools/report/words.hpp"
#include "tools/run/joined_by_and.hpp"

namespace legwright {
namespace {

bool in_percent(const LimitRow& row) {
  return row.unit == "1" && (row.name.find("share") != std::string::npos ||
                             row.name.find("ratio") != std::string::npos ||
                             row.name.find("survival") != std::string::npos);
}

/// Shares and ratios in per cent, the rest in its unit.
std::string value_words(const LimitRow& row, std::optional<double> value) {
  return in_percent(row) ? percent(value) : amount_words(value, row.unit);
}

/// The same of a value beside a bound that would read the same: with the digits that tell them
/// apart.
std::string words_beside(const LimitRow& row, double value, double bound) {
  constexpr int kMostDecimals = 9;
  const ShownUnit unit =
      in_percent(row) ? ShownUnit{100.0, "%"} : shown_unit(row.unit, std::abs(value));
  for (int decimals = 2; decimals <= kMostDecimals; ++decimals) {
    const std::string text = signed_text(value * unit.scale, decimals);
    if (text == signed_text(bound * unit.scale, decimals)) continue;
    return unit.name.empty() || unit.name == "°" ? text + unit.name : text + " " + unit.name;
  }
  return value_words(row, value);
}

}  // namespace

std::string with_degrees(const std::string& sentence) {
  static constexpr std::string_view kUnit = " rad";
  std::string out;
  std::size_t done = 0;
  for (std::size_t at = sentence.find(kUnit); at != std::string::npos;
       at = sentence.find(kUnit, at + 1)) {
    const std::size_t end = at + kUnit.size();
    const bool angle = end == sentence.size() ||
                       std::string_view(" ,;.:)").find(sentence[end]) != std::string_view::npos;
    const std::size_t before = sentence.find_last_not_of("0123456789.", at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    double radian = 0.0;
    const auto read = std::from_chars(sentence.data() + begin, sentence.data() + at, radian);
    if (!angle || begin < done || read.ec != std::errc() || read.ptr != sentence.data() + at)
      continue;
    out += fmt::format("{}{:.1f}° ({})", sentence.substr(done, begin - done), radian * kDegrees,
                       sentence.substr(begin, end - begin));
    done = end;
  }
  return out + sentence.substr(done);
}

std::string verdict_details(const std::string& line) {
  const std::size_t colon = line.find(": ");
  return with_degrees(colon == std::string::npos ? line : line.substr(colon + 2));
}

std::string measured_words(const LimitRow& row) {
  if (!row.value) return "not measured";
  std::string text = value_words(row, row.value);
  for (const std::optional<double>& bound : {row.low, row.high}) {
    const bool alike = bound && *bound != *row.value && value_words(row, bound) == text;
    if (alike && (row.strict || !row.pass)) return words_beside(row, *row.value, *bound);
  }
  return text;
}

std::string bound_words(const LimitRow& row) {
  if (row.low && row.high)
    return (row.strict ? "strictly within " : "") + value_words(row, row.low) + " … " +
           value_words(row, row.high);
  if (row.low) return (row.strict ? "more than " : "at least ") + value_words(row, row.low);
  if (row.high) return (row.strict ? "less than " : "at most ") + value_words(row, row.high);
  return "–";
}

std::string limits_kept(const std::vector<LimitRow>& rows) {
  const auto kept =
      std::count_if(rows.begin(), rows.end(), [](const LimitRow& row) { return row.pass; });
  return static_cast<std::size_t>(kept) == rows.size()
             ? fmt::format("All {} limits are kept.", rows.size())
             : fmt::format("{} of {} limits are kept.", kept, rows.size());
}

ShownUnit unit_of(const RobustnessFactor& factor) {
  return shown_unit(factor.unit,
                    std::max(std::abs(factor.tested_low), std::abs(factor.tested_high)));
}

std::string margin_words(const RobustnessFactor& factor) {
  const ShownUnit unit = unit_of(factor);
  if (!factor.low && !factor.high)
    return fmt::format("survives from {} to {}, all that was tried", unit.words(factor.tested_low),
                       unit.words(factor.tested_high));
  const auto side = [&](const std::optional<double>& value, const std::optional<double>& fails,
                        double tested, const char* beyond) {
    if (!value) return unit.words(tested) + beyond;
    return unit.words(value) +
           (fails == tested ? " (all tried but " + unit.words(tested) + ")" : "");
  };
  const std::string high = side(factor.high, factor.high_fails, factor.tested_high, " or more");
  const bool one_sided = factor.nominal <= factor.tested_low;
  if (!factor.low && one_sided) return "survives up to " + high;
  return fmt::format("survives from {} to {}",
                     side(factor.low, factor.low_fails, factor.tested_low, " or less"), high);
}

std::string no_margins_words(const JudgedData& data) {
  if (!data.robustness || !data.robustness->undisturbed_cause) return "";
  return fmt::format("No margins: the gait fails undisturbed: {}.",
                     *data.robustness->undisturbed_cause);
}

std::string survival_words(const MonteCarlo& drawn) {
  if (drawn.samples < 1) return "";
  std::string out = fmt::format("{} of {} draws survived: {}", drawn.survived, drawn.samples,
                                percent(finite(drawn.share)));
  const auto low = finite(drawn.share_low), high = finite(drawn.share_high);
  if (low && high) out += fmt::format(" (95 % interval {} … {})", percent(low), percent(high));
  return out + ".";
}

std::string numerics_words(const NumericsRecord& numerics) {
  std::string out =
      numerics.agree
          ? "All agree: the verdict does not hang on how the physics is computed."
          : "They do not agree: part of what was measured comes from how the physics is computed.";
  for (const std::string& reason : numerics.reasons) out += fmt::format(" {}.", reason);
  return out;
}

std::string engine_name(const EngineRecord& record) {
  std::string name = record.engine == kDrake ? "Drake" : record.engine;
  return name + " " + record.version;
}

std::string engine_words(const EngineRecord& record) {
  std::vector<std::string> good, bad;
  for (const auto& [gains, pass] : record.passes) (pass ? good : bad).push_back(gains);
  std::string out = engine_name(record);
  if (!good.empty()) out += " passes at " + joined_by_and(good) + " gains";
  if (!bad.empty())
    out += (good.empty() ? " fails at " : " and fails at ") + joined_by_and(bad) + " gains";
  const char* lead = ", at ";
  const auto told = [&](std::optional<double> GainMetrics::*ratio, const char* what) {
    std::optional<double> low, high;
    for (const auto& [gains, measured] : record.result)
      if (const std::optional<double>& value = measured.*ratio) {
        low = std::min(low.value_or(*value), *value);
        high = std::max(high.value_or(*value), *value);
      }
    if (!low) return;
    out += fmt::format("{}{} … {} of the planned {}", lead, percent(low), percent(high), what);
    lead = " and ";
  };
  told(&GainMetrics::speed_ratio, "speed");
  told(&GainMetrics::turn_ratio, "turn rate");
  out += ".";
  if (record.verdict.pass) return out;
  for (const std::string& reason : record.verdict.reasons)
    out += " It " + with_degrees(reason) + ".";
  return out;
}

std::string inverse_dynamics_words(const InverseDynamics& plan) {
  const auto at = [](const std::string& foot, double phase) {
    return (foot.empty() ? "" : " at " + spaced(foot)) +
           fmt::format(", at {} of the cycle", percent_whole(phase));
  };
  return fmt::format(
      "The planned forces and the planned motion agree to {} of the weight at worst, {} in the "
      "mean, and about the body’s axes to {} of weight × height. The plan uses {} of friction, "
      "where the floor gives {} (most{}). The least load of a foot that is meant to bear is {}, {} "
      "of the weight{}.",
      percent(finite(plan.force_max)), percent(finite(plan.force_rms)),
      percent(finite(plan.torque_max)), short_number(finite(plan.friction_max)),
      short_number(plan.friction_coefficient), at(plan.friction_foot, plan.friction_phase),
      amount_words(finite(plan.normal_min), "N"), percent(finite(plan.normal_min_share)),
      at(plan.normal_foot, plan.normal_phase));
}

}  // namespace legwright
