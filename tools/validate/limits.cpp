// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mjcf/text/numbers.hpp"
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

/// A number with so many digits more than usual, without its unit; percents as such.
std::string digits(const LimitedQuantity& quantity, double value, int more) {
  std::string text;
  if (quantity.told == Told::percent)
    text = fmt::format("{:.{}f}", 100 * value, 1 + more);
  else if (quantity.told == Told::thousandths)
    text = fmt::format("{:.{}f}", value, 3 + more);
  else
    text = fmt::format("{:.{}g}", value, 3 + more);
  return text.find_first_not_of("-0.") == std::string::npos && text[0] == '-' ? text.substr(1)
                                                                              : text;
}

/// Whether a number reads as one that passes.
bool reads_as_good(const std::string& text, const LimitedQuantity& quantity, const Bounds& bounds) {
  const double scale = quantity.told == Told::percent ? 100.0 : 1.0;
  const double number = parse_number(text).value();
  const auto over = [&](double bound) {  // by more than 100 · 0.001 differs from 0.1
    return (number - scale * bound) / std::max(std::abs(scale * bound), 1e-12);
  };
  constexpr double kRounding = 1e-9;
  if (bounds.low && over(*bounds.low) < -kRounding) return false;
  return !bounds.high || over(*bounds.high) < (quantity.below ? -kRounding : kRounding);
}

/// What misses its bounds, with as many digits as show it.
std::string told(const LimitedQuantity& quantity, const std::optional<double>& value,
                 const Bounds& bounds) {
  const bool percent = quantity.told == Told::percent;
  if (!value || !std::isfinite(*value)) return percent ? "an unknown share" : "an unknown amount";
  constexpr int kMostMore = 12;
  std::string text = digits(quantity, *value, 0);
  for (int more = 1; more <= kMostMore && reads_as_good(text, quantity, bounds); ++more)
    text = digits(quantity, *value, more);
  if (percent) return text + " %";
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
      faults.push_back(told(quantity, value, bounds) + " at " + gain_name(run.gain_scale));
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
