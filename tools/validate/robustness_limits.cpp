// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/robustness_limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace legwright {
namespace {

/// In units for people: degrees, milliseconds.
std::string shown(double value, const std::string& unit, bool with_unit = true) {
  const auto text = [&](double scaled, const char* name, int digits) {
    const std::string number = fmt::format("{:.{}g}", scaled, digits);
    return (number == "-0" ? "0" : number) + (with_unit && *name != '\0' ? " " : "") +
           (with_unit ? name : "");
  };
  if (unit == "rad") return text(value * 180 / std::numbers::pi, "deg", 2);
  if (unit == "s") return text(value * 1e3, "ms", 2);
  if (unit == "m") return text(value * 1e3, "mm", 2);
  return text(value, unit == "1" ? "" : unit.c_str(), 2);
}

/// "friction of the floor (0.8)", "survives from 0.155 to 2 (tested)": it neither falls nor stays
/// behind, which is less than a verdict that passes. Where of all that was tried only the end of
/// the range fails, it is named: "from 0.011 (all tried but 0.01)".
std::pair<std::string, std::string> margin_words(const Margin& margin) {
  const DisturbanceFactor& factor = margin.factor;
  std::string label = factor.label;
  if (margin.nominal != 0.0 && margin.nominal != 1.0)
    label += " (" + shown(margin.nominal, factor.unit) + ")";
  const auto side = [&](const std::optional<double>& value, const std::optional<double>& fails,
                        double tested) {
    return shown(value.value_or(tested), factor.unit) +
           (!value            ? " (tested)"
            : fails == tested ? " (all tried but " + shown(tested, factor.unit) + ")"
                              : "");
  };
  std::string out = "survives ";
  if (factor.tested_low < margin.nominal)
    out += "from " + side(margin.low, margin.low_fails, factor.tested_low) + " ";
  if (!margin.low && !margin.high && factor.tested_low < margin.nominal)
    return {label, "survives from " + shown(factor.tested_low, factor.unit) + " to " +
                       shown(factor.tested_high, factor.unit) + ", all that was tested"};
  return {label, out + (factor.tested_low < margin.nominal ? "to " : "up to ") +
                     side(margin.high, margin.high_fails, factor.tested_high)};
}

JudgedLimit survival_limit(const SurvivalShare& survival, const Bounds& bounds) {
  JudgedLimit out{"survival", "share of disturbed walks that survive", "1", bounds, {}, "", false,
                  ""};
  if (survival.samples > 0) out.value = survival.share();
  out.where = fmt::format("{} samples", survival.samples);
  out.pass = within(out.value, bounds);
  if (!out.pass)
    out.reason = fmt::format("{} of {} disturbed walks survive ({})", survival.survived,
                             survival.samples, what_passes(bounds, "1", Told::percent, false));
  return out;
}

/// One side of a margin: the last good value against the one that is asked for.
JudgedLimit margin_limit(const Margin& margin, bool low, double asked) {
  const DisturbanceFactor& factor = margin.factor;
  const auto& last_good = low ? margin.low : margin.high;
  JudgedLimit out;
  out.name = kMarginPrefix + factor.name + (low ? ".low" : ".high");
  out.what = factor.label + (low ? ": survives down to" : ": survives up to");
  out.unit = factor.unit;
  (low ? out.bounds.high : out.bounds.low) = asked;
  out.value = last_good.value_or(low ? factor.tested_low : factor.tested_high);
  out.where = last_good ? "" : "as far as tested";
  out.pass = within(out.value, out.bounds);
  if (!out.pass) {
    out.reason = fmt::format("{} {}, not {}", out.what, shown(*out.value, factor.unit),
                             shown(asked, factor.unit));
    if (const std::string& cause = low ? margin.low_cause : margin.high_cause; !cause.empty())
      out.reason += " (" + cause + ")";
  }
  return out;
}

}  // namespace

std::vector<std::string> robustness_lines(const Robustness& robustness) {
  if (robustness.nominal_cause)
    return {"no margins: started from rest it fails undisturbed, " + *robustness.nominal_cause};
  std::vector<std::string> out;
  for (const auto& margin : robustness.margins) {
    const auto [label, words] = margin_words(margin);
    out.push_back(fmt::format("{:<50}  {}", label, words));
  }
  const SurvivalShare& survival = robustness.survival;
  if (survival.samples == 0) return out;
  std::string line = fmt::format("{} of {} disturbed walks survive: {:.1f} % ({:.0f} to {:.0f} %)",
                                 survival.survived, survival.samples, 100 * survival.share(),
                                 100 * survival.low, 100 * survival.high);
  std::string causes;
  for (const auto& [cause, count] : survival.causes)
    causes += fmt::format("{} {} × {}", causes.empty() ? ";" : ",", count, cause);
  out.push_back(line + causes);
  return out;
}

std::vector<std::string> robustness_limit_names() {
  std::vector<std::string> out{"survival"};
  for (const auto& factor : disturbance_factors({})) out.push_back(kMarginPrefix + factor.name);
  return out;
}

std::vector<JudgedLimit> judge_robustness(const Robustness& robustness, const Limits& limits) {
  std::vector<JudgedLimit> out;
  for (const auto& factor : disturbance_factors({})) {
    const auto found = limits.find(kMarginPrefix + factor.name);
    if (found == limits.end()) continue;
    Margin none;  // where the undisturbed walk fails
    none.factor = factor;
    const Margin* margin = &none;
    for (const auto& one : robustness.margins)
      if (one.factor.name == factor.name) margin = &one;
    for (const bool low : {true, false}) {
      const auto& asked = low ? found->second.low : found->second.high;
      if (!asked) continue;
      out.push_back(margin_limit(*margin, low, *asked));
      if (margin != &none) continue;
      out.back().value.reset();
      out.back().where.clear();
      out.back().pass = false;
      out.back().reason = out.back().what + " nothing: it fails undisturbed";
    }
  }
  if (const auto found = limits.find("survival"); found != limits.end() && found->second.any())
    out.push_back(survival_limit(robustness.survival, found->second));
  return out;
}

std::map<std::string, std::pair<double, double>> tested_for(const Limits& limits) {
  std::map<std::string, std::pair<double, double>> out;
  for (const auto& factor : disturbance_factors({})) {
    const auto found = limits.find(kMarginPrefix + factor.name);
    if (found == limits.end()) continue;
    out[factor.name] = {found->second.low.value_or(factor.tested_low),
                        found->second.high.value_or(factor.tested_high)};
  }
  return out;
}

}  // namespace legwright
