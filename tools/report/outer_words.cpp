// SPDX-License-Identifier: Apache-2.0
#include "tools/report/outer_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/report/words.hpp"

namespace legwright {
namespace {

/// The figure that shows in physics what an outer objective is to lower.
const char* measured_row(const std::string& objective) {
  static const std::map<std::string, const char*, std::less<>> kRows{
      {"peak_torque", "peak torque of a servo"},
      {"mechanical_work", "mechanical power"},
      {"printed_volume", "printed volume"}};
  const auto found = kRows.find(objective);
  return found == kRows.end() ? nullptr : found->second;
}

}  // namespace

std::optional<double> outer_amount(const OuterRecord& outer, std::optional<double> J) {
  if (!J || outer.objective != "peak_torque") return J;
  if (!(*J >= 0.0) || !(outer.weight > 0.0)) return std::nullopt;
  return std::pow(2.0 * *J / outer.weight, 0.125);
}

std::string outer_words(const RunRecord& run, const std::vector<EffectRow>& rows) {
  if (!run.outer) return "";
  std::string out = fmt::format("The body was to lower {}.", spaced(run.outer->objective));
  const char* const name = measured_row(run.outer->objective);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const EffectRow& each) {
    return name != nullptr && each.what == name;
  });
  if (row == rows.end()) return out + " What came of it is not measured.";
  out += fmt::format(" Measured: {} {} before, {} after", name, row->before, row->after);
  if (!row->effect.change) return out + ".";
  return out + fmt::format(" ({}){}", change_words(*row->effect.change),
                           *row->effect.change < 0.0 ? "." : ": it did not fall.");
}

}  // namespace legwright
