// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/run/joined_by_and.hpp"
#include "tools/run/worst_words.hpp"

namespace legwright {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of a robot that fell or flew apart nothing else is told: the rest follows from it.
bool ended_early(const Measurements& run) { return run.fall || run.diverged; }

std::string three_digits(double value) {
  const std::string text = fmt::format("{:.3g}", value);
  return text == "-0" ? "0" : text;
}

std::string told(const LimitedQuantity& quantity, const std::optional<double>& value) {
  if (!value || !std::isfinite(*value))
    return quantity.told == Told::percent ? "an unknown share" : "an unknown amount";
  if (quantity.told == Told::percent) {
    const std::string text = fmt::format("{:.1f} %", 100 * *value);
    return text == "-0.0 %" ? "0.0 %" : text;
  }
  const std::string text =
      quantity.told == Told::thousandths ? fmt::format("{:.3f}", *value) : three_digits(*value);
  return quantity.unit == "1" ? text : text + " " + quantity.unit;
}

/// How far inside its bounds, in their own unit; negative outside, least where unknown.
double room(const std::optional<double>& value, const Bounds& bounds) {
  if (!value || !std::isfinite(*value)) return -kInfinity;
  double least = kInfinity;
  if (bounds.low) least = std::min(least, *value - *bounds.low);
  if (bounds.high) least = std::min(least, *bounds.high - *value);
  return least;
}

/// Bodies that touch are told by the verdict, as a pair.
std::string worst_but_touches(const std::vector<WorstPart>& worst) {
  return worst.empty() || worst.front().kind == "body" ? "" : worst_words(worst);
}

JudgedLimit judge_one(const LimitedQuantity& quantity, const Bounds& bounds,
                      const std::vector<Measurements>& at_gains) {
  JudgedLimit out{quantity.name, quantity.what, quantity.unit, bounds, {}, "", true, ""};
  out.strict = quantity.below && bounds.high;
  std::vector<std::string> faults;
  double least = 0.0;
  for (const auto& run : at_gains) {
    if (ended_early(run)) continue;
    std::optional<double> value = quantity.value(run);
    if (value && !std::isfinite(*value)) value.reset();
    if (const double left = room(value, bounds); out.where.empty() || left < least) {
      out.value = value;
      out.where = gain_name(run.gain_scale) + " gains";
      out.worst = quantity.worst(run);
      least = left;
    }
    if (!within(value, bounds, quantity.below))
      faults.push_back(told(quantity, value) + " at " + gain_name(run.gain_scale));
  }
  if (out.where.empty()) {  // every roll-out ended early, which is a reason of its own
    out.pass = false;
    return out;
  }
  out.pass = faults.empty();
  if (out.pass) return out;
  const std::string passes = what_passes(bounds, quantity.unit, quantity.told, quantity.below);
  out.reason = quantity.verb + " " + joined_by_and(faults) + " gains (" + quantity.note +
               (quantity.note.empty() ? "" : "; ") + passes + worst_but_touches(out.worst) + ")";
  return out;
}

}  // namespace

std::string gain_name(double scale) {
  if (scale == 0.5) return "half";
  if (scale == 1.0) return "default";
  if (scale == 2.0) return "double";
  return fmt::format("{}-fold", scale);
}

bool within(const std::optional<double>& value, const Bounds& bounds, bool below) {
  if (!value || !std::isfinite(*value)) return false;
  if (bounds.low && *value < *bounds.low) return false;
  return !bounds.high || (below ? *value < *bounds.high : *value <= *bounds.high);
}

std::string what_passes(const Bounds& bounds, const std::string& unit, Told told, bool below) {
  const bool percent = told == Told::percent;
  const auto text = [&](double value) { return three_digits(percent ? 100 * value : value); };
  const std::string tail = (percent       ? " %"
                            : unit == "1" ? ""
                                          : " " + unit) +
                           (percent ? " pass" : " passes");
  if (bounds.low && bounds.high && below)
    return "at least " + text(*bounds.low) + " and less than " + text(*bounds.high) + tail;
  if (bounds.low && bounds.high) return text(*bounds.low) + " to " + text(*bounds.high) + tail;
  if (bounds.low) return "at least " + text(*bounds.low) + tail;
  return (below ? "less than " : "up to ") + text(bounds.high.value_or(kInfinity)) + tail;
}

Limits default_limits() {
  Limits out;
  for (const auto& quantity : limited_quantities())
    if (quantity.by_default.any()) out[quantity.name] = quantity.by_default;
  out["numerics"] = {{}, 0.0};
  return out;
}

Limits with_step_over(Limits limits, double height) {
  if (height > 0.0)
    if (Bounds& bar = limits["foot_clearance"]; !bar.low) bar.low = height;
  return limits;
}

std::vector<JudgedLimit> judge_limits(const std::vector<Measurements>& at_gains,
                                      const WantedMotion& wanted, const Limits& limits) {
  std::vector<JudgedLimit> out;
  for (const auto& quantity : limited_quantities()) {
    const auto found = limits.find(quantity.name);
    if (found == limits.end() || !found->second.any() || !quantity.asked(wanted)) continue;
    out.push_back(judge_one(quantity, found->second, at_gains));
  }
  return out;
}

}  // namespace legwright
