// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace legwright {
namespace {

/// "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    out += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return out;
}

bool within(const std::optional<double>& value, double low, double high) {
  return value && *value >= low && *value <= high;  // false for NaN
}

// What one kind of fault was at each gain that has it, as one sentence.
class Reason {
 public:
  explicit Reason(std::string what) : what_(std::move(what)) {}
  void add(double gain, const std::string& how_much) {
    parts_.push_back((how_much.empty() ? "" : how_much + " ") + "at " + gain_name(gain));
  }
  void add_to(std::vector<std::string>& reasons, const std::string& limit = "") const {
    if (parts_.empty()) return;
    reasons.push_back(what_ + " " + listed(parts_) + " gains" +
                      (limit.empty() ? "" : " (" + limit + ")"));
  }

 private:
  std::string what_;
  std::vector<std::string> parts_;
};

std::string percent(const std::optional<double>& ratio) {
  if (!ratio || !std::isfinite(*ratio)) return "an unknown share";
  const std::string text = fmt::format("{:.1f} %", 100 * *ratio);
  return text == "-0.0 %" ? "0.0 %" : text;
}

void health_reasons(const std::vector<Measurements>& at_gains, std::vector<std::string>& reasons) {
  for (const auto& run : at_gains) {
    for (const auto& warning : run.warnings) {
      reasons.push_back(fmt::format("MuJoCo warns after {:.2f} s at {} gains: {}{}", warning.time,
                                    gain_name(run.gain_scale), warning.text,
                                    run.diverged ? "; the simulation diverged" : ""));
    }
    if (run.diverged && run.warnings.empty()) {
      reasons.push_back("the simulation diverged at " + gain_name(run.gain_scale) + " gains");
    }
  }
}

void fall_reasons(const std::vector<Measurements>& at_gains, std::vector<std::string>& reasons) {
  Reason falls("falls after");
  std::vector<std::string> causes;
  for (const auto& run : at_gains) {
    if (!run.fall) continue;
    falls.add(run.gain_scale, fmt::format("{:.2f} s", run.fall->time));
    if (std::find(causes.begin(), causes.end(), run.fall->cause) == causes.end())
      causes.push_back(run.fall->cause);
  }
  falls.add_to(reasons, listed(causes));
}

// Of a robot that fell or flew apart nothing else is told: the rest follows from it.
bool ended_early(const Measurements& run) { return run.fall || run.diverged; }

void motion_reasons(const std::vector<Measurements>& at_gains, const WantedMotion& wanted,
                    const VerdictLimits& limits, std::vector<std::string>& reasons) {
  Reason slow("reaches"), drift("moves at"), turn("turns at"), tilt("tilts by"),
      saturated("saturates servos");
  std::optional<double> turned;  // by the plan, so the same at all gains
  for (const auto& run : at_gains) {
    if (ended_early(run)) continue;
    const double gain = run.gain_scale;
    if (!(run.saturated_share < limits.saturated_share)) {
      saturated.add(gain, fmt::format("{:.1f} % of the time", 100 * run.saturated_share));
    }
    if (wanted.travels()) {
      if (!within(run.speed_ratio, limits.speed_ratio_low, limits.speed_ratio_high)) {
        slow.add(gain, percent(run.speed_ratio));
        if (std::abs(run.heading_at_start) > limits.told_heading) {
          turned = run.heading_at_start;
        }
      }
    } else if (!run.velocity || !(run.velocity->norm() <= limits.standing_speed)) {
      drift.add(gain, run.velocity ? fmt::format("{:.3f} m/s", run.velocity->norm())
                                   : "an unknown speed");
    }
    if (wanted.turns() && !within(run.turn_ratio, limits.turn_ratio_low, limits.turn_ratio_high)) {
      turn.add(gain, percent(run.turn_ratio));
    }
    if (!(run.tilt_max < limits.tilt)) tilt.add(gain, fmt::format("{:.3f} rad", run.tilt_max));
  }
  saturated.add_to(reasons);
  if (turned) {
    reasons.push_back(fmt::format(
        "its plan turns the trunk by {:.2f} rad, and speed counts along its own heading", *turned));
  }
  slow.add_to(reasons, fmt::format("of the planned speed; {:.0f} to {:.0f} % pass",
                                   100 * limits.speed_ratio_low, 100 * limits.speed_ratio_high));
  drift.add_to(reasons,
               fmt::format("it should stay; up to {:.3f} m/s passes", limits.standing_speed));
  turn.add_to(reasons, fmt::format("of the planned turn rate; {:.0f} to {:.0f} % pass",
                                   100 * limits.turn_ratio_low, 100 * limits.turn_ratio_high));
  tilt.add_to(reasons, fmt::format("less than {} rad passes", limits.tilt));
}

std::string range(const std::vector<Measurements>& at_gains,
                  const std::function<double(const Measurements&)>& quantity, const char* unit) {
  double low = INFINITY, high = -INFINITY;
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
  return out + fmt::format("no fall ({} cycles; {} gains)", at_gains.front().cycles, listed(gains));
}

}  // namespace

std::string gain_name(double scale) {
  if (scale == 0.5) return "half";
  if (scale == 1.0) return "default";
  if (scale == 2.0) return "double";
  return fmt::format("{}-fold", scale);
}

std::string describe(const WantedMotion& wanted, const std::string& gait) {
  const double forward = wanted.velocity.x(), left = wanted.velocity.y();
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
              const std::string& gait, const VerdictLimits& limits) {
  if (at_gains.empty()) throw std::invalid_argument("judge: no roll-out");
  Verdict verdict;
  health_reasons(at_gains, verdict.reasons);
  fall_reasons(at_gains, verdict.reasons);
  motion_reasons(at_gains, wanted, limits, verdict.reasons);
  verdict.pass = verdict.reasons.empty();
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
