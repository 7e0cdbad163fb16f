// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "optimizer/motion/faced_frame.hpp"
#include "tools/run/joined_by_and.hpp"

namespace legwright {
namespace {

constexpr double kToldHeading = 0.3;  // [rad]

// What must never happen, as rows: how many roll-outs had it.
JudgedLimit count_of(const char* name, const char* what, const std::vector<Measurements>& at_gains,
                     const std::function<bool(const Measurements&)>& has) {
  JudgedLimit out{name, what, "1", {{}, 0.0}, {}, "", true, ""};
  std::vector<std::string> gains;
  for (const auto& run : at_gains)
    if (has(run)) gains.push_back(gain_name(run.gain_scale));
  out.value = static_cast<double>(gains.size());
  out.pass = gains.empty();
  if (!out.pass) out.where = joined_by_and(gains) + " gains";
  return out;
}

JudgedLimit warned(const std::vector<Measurements>& at_gains) {
  JudgedLimit out = count_of("warnings", "roll-outs in which MuJoCo warns or diverges", at_gains,
                             [](const auto& run) { return run.diverged || !run.warnings.empty(); });
  const auto add = [&](const std::string& reason) {
    out.reason += (out.reason.empty() ? "" : "; ") + reason;
  };
  for (const auto& run : at_gains) {
    for (const auto& warning : run.warnings) {
      add(fmt::format("MuJoCo warns after {:.2f} s at {} gains: {}{}", warning.time,
                      gain_name(run.gain_scale), warning.text,
                      run.diverged ? "; the simulation diverged" : ""));
    }
    if (run.diverged && run.warnings.empty())
      add("the simulation diverged at " + gain_name(run.gain_scale) + " gains");
  }
  return out;
}

JudgedLimit fell(const std::vector<Measurements>& at_gains) {
  JudgedLimit out = count_of("falls", "roll-outs in which the robot falls", at_gains,
                             [](const auto& run) { return run.fall.has_value(); });
  std::vector<std::string> times, causes;
  for (const auto& run : at_gains) {
    if (!run.fall) continue;
    times.push_back(fmt::format("{:.2f} s at {}", run.fall->time, gain_name(run.gain_scale)));
    if (std::find(causes.begin(), causes.end(), run.fall->cause) == causes.end())
      causes.push_back(run.fall->cause);
  }
  if (!out.pass)
    out.reason =
        fmt::format("falls after {} gains ({})", joined_by_and(times), joined_by_and(causes));
  return out;
}

/// Why it may be too slow along its own heading: the plan, the same at all gains, turns away.
std::optional<std::string> turned_away(const std::vector<Measurements>& at_gains) {
  std::optional<double> turned;
  for (const auto& run : at_gains)
    if (!run.fall && !run.diverged && std::abs(run.heading_at_start) > kToldHeading)
      turned = run.heading_at_start;
  if (!turned) return std::nullopt;
  return fmt::format(
      "its plan turns the trunk by {:.2f} rad, and speed counts along its own heading", *turned);
}

constexpr double kToldContact = 0.01;  // share of the time

/// What the planner does not see: geoms of a robot that meet. Often why it fails, and a fault by
/// itself where it lasts. @param told by a row that fails: then only where it was is left to say
std::optional<std::string> touched_itself(const std::vector<Measurements>& at_gains, bool told) {
  const auto worst = std::max_element(at_gains.begin(), at_gains.end(),
                                      [](const Measurements& a, const Measurements& b) {
                                        return a.self_contact.share < b.self_contact.share;
                                      });
  const SelfContact& touch = worst->self_contact;
  if ((touch.share < kToldContact && !told) || touch.first.empty()) return std::nullopt;
  if (told)
    return fmt::format("hardest touch: {} on {} at {} gains", touch.first, touch.second,
                       gain_name(worst->gain_scale));
  return fmt::format("touches itself for {:.0f} % of the time at {} gains, hardest {} on {}",
                     100.0 * touch.share, gain_name(worst->gain_scale), touch.first, touch.second);
}

std::string range(const std::vector<Measurements>& at_gains,
                  const std::function<double(const Measurements&)>& quantity, const char* unit) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  double low = kEndless, high = -kEndless;
  for (const auto& run : at_gains) {
    low = std::min(low, quantity(run));
    high = std::max(high, quantity(run));
  }
  const std::string from = fmt::format("{:.0f}", low), to = fmt::format("{:.0f}", high);
  return (from == to ? from : from + " to " + to) + unit;
}

std::string praise(const std::vector<Measurements>& at_gains, const WantedMotion& wanted) {
  std::vector<std::string> facts;
  if (wanted.travels()) {
    facts.push_back(
        range(
            at_gains, [](const Measurements& run) { return 100 * *run.speed_ratio; }, " %") +
        " of planned speed");
  }
  if (wanted.turns()) {
    facts.push_back(
        range(
            at_gains, [](const Measurements& run) { return 100 * *run.turn_ratio; }, " %") +
        " of planned turn rate");
  }
  double tilt = 0.0;
  std::vector<std::string> gains;
  for (const auto& run : at_gains) {
    tilt = std::max(tilt, run.tilt_max);
    gains.push_back(gain_name(run.gain_scale));
  }
  facts.push_back(fmt::format("tilt {:.2f} rad", tilt));
  std::string out;
  for (const auto& fact : facts) out += fact + ", ";
  out +=
      fmt::format("no fall ({} cycles; {} gains)", at_gains.front().cycles, joined_by_and(gains));
  if (const auto touch = touched_itself(at_gains, false)) out += "; " + *touch;
  return out;
}

}  // namespace

std::string describe(const WantedMotion& wanted, const std::string& gait) {
  const Eigen::Vector2d velocity = as_faced(wanted.velocity, wanted.forward);
  const double forward = velocity.x(), left = velocity.y();
  std::string out = gait;
  if (wanted.travels()) {
    const bool mostly_ahead = std::abs(forward) >= 5 * std::abs(left);
    const bool mostly_aside = std::abs(left) >= 5 * std::abs(forward);
    out += mostly_ahead   ? (forward > 0 ? " forward" : " backward")
           : mostly_aside ? " sideways"
                          : " diagonally";
    out += fmt::format(" at {:.3f} m/s", wanted.velocity.norm());
  } else if (!wanted.turns()) {
    out += " on the spot";
  }
  if (wanted.turns())
    out += fmt::format("{} turning at {:.3f} rad/s", wanted.travels() ? "," : "", wanted.turn_rate);
  return out;
}

Verdict judge(const std::vector<Measurements>& at_gains, const WantedMotion& wanted,
              const std::string& gait, const Limits& limits,
              const std::vector<JudgedLimit>& further) {
  if (at_gains.empty()) throw std::invalid_argument("judge: no roll-out");
  Verdict verdict;
  verdict.limits = {warned(at_gains), fell(at_gains)};
  for (auto& row : judge_limits(at_gains, wanted, limits)) verdict.limits.push_back(std::move(row));
  verdict.limits.insert(verdict.limits.end(), further.begin(), further.end());
  verdict.pass = true;
  bool touch_told = false;
  for (const auto& row : verdict.limits) {
    verdict.pass = verdict.pass && row.pass;
    if (row.reason.empty()) continue;
    touch_told = touch_told || row.name.starts_with("self_contact");
    if (row.name == "speed_ratio")
      if (auto why = turned_away(at_gains)) verdict.reasons.push_back(*std::move(why));
    verdict.reasons.push_back(row.reason);
  }
  if (!verdict.pass)
    if (auto why = touched_itself(at_gains, touch_told)) verdict.reasons.push_back(*std::move(why));
  verdict.line = (verdict.pass ? "PASS  " : "FAIL  ") + describe(wanted, gait) + ": ";
  if (verdict.pass) {
    verdict.line += praise(at_gains, wanted);
  } else {
    for (std::size_t i = 0; i < verdict.reasons.size(); ++i)
      verdict.line += (i ? "; " : "") + verdict.reasons[i];
  }
  return verdict;
}

}  // namespace legwright
