// SPDX-License-Identifier: Apache-2.0
#include "tools/report/outer_words.hpp"

#include <fmt/format.h>

#include <vector>

#include "tools/report/number_words.hpp"
#include "tools/report/words.hpp"
#include "tools/run/outer_measured.hpp"

namespace legwright {
namespace {

using Value = std::optional<double>;

/// "1.23 N·m before, 1.02 N·m after (−17 %)"
std::string change_of(const OuterRecord& outer, Value before, Value after) {
  std::string out = fmt::format("{} before, {} after", outer_amount_words(outer, before),
                                outer_amount_words(outer, after));
  if (before && after && *before > 0.0)
    out += fmt::format(" ({})", change_words((*after - *before) / *before));
  return out;
}

Value at(const ByName<double>& gains, const char* gain) {
  const double* const found = gains.find(gain);
  return found == nullptr ? std::nullopt : Value(*found);
}

std::string measured_words(const OuterRecord& outer, const OuterMeasured& measured) {
  std::string out, risen;
  for (const char* const gain : kGains) {
    const Value before = at(measured.initial, gain), after = at(measured.result, gain);
    if (!before && !after) continue;
    out += fmt::format("{}at {} gains {}", out.empty() ? " Measured: " : "; ", gain,
                       change_of(outer, before, after));
    if (before && after && !(*after < *before))
      risen += fmt::format("{}{}", risen.empty() ? "" : " and ", gain);
  }
  if (out.empty()) return " What came of it in MuJoCo is not measured.";
  return out + "." + (risen.empty() ? "" : " It did not fall at " + risen + " gains.");
}

}  // namespace

std::string outer_amount_words(const OuterRecord& outer, Value amount) {
  const std::string unit = outer.unit.value_or("");
  if (unit == "m^3") return amount ? short_number(*amount * 1e6) + " cm³" : "–";
  return amount_words(amount, unit);
}

std::string outer_words(const RunData& data) {
  if (!data.run.outer) return "";
  const OuterRecord& outer = *data.run.outer;
  std::string out = fmt::format("The body was to lower {}.", spaced(outer.objective));
  if (outer.plan_initial || outer.plan_final)
    out += fmt::format(" {}: {}.", outer.unit == "m^3" ? "Of the bodies" : "In the plan",
                       change_of(outer, outer.plan_initial, outer.plan_final));
  if (outer.unit == "m^3") return out;
  const auto measured =
      data.metrics ? outer_measured(outer, *data.metrics) : std::optional<OuterMeasured>();
  return out + measured_words(outer, measured.value_or(OuterMeasured{}));
}

}  // namespace legwright
