// SPDX-License-Identifier: Apache-2.0
// Whether other step sizes, integrators and contact models come to the same verdict.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostRuns = 24;
constexpr double kSame = 5e-3;  // of a value: smaller differences are not worth telling

struct Column {
  const char *key, *head, *unit;
};
constexpr Column kColumns[] = {{"speed_ratio", "of planned speed", "%"},
                               {"turn_ratio", "of planned turn", "%"},
                               {"tilt_max_rad", "largest tilt", "rad"},
                               {"heading_drift_rad", "heading drift", "rad"},
                               {"torque_rms_Nm", "torque, RMS", "N m"}};

/// A value with its unit; a ratio as a percentage.
std::string shown(std::optional<double> value, const char* unit) {
  return std::string_view(unit) == "%" ? percent(value) : amount_words(value, unit);
}

/// "+0.3 %", "−1.2°"; empty without a difference.
std::string difference_words(std::optional<double> difference, std::optional<double> value,
                             const char* unit) {
  if (!difference) return "";
  const bool ratio = std::string_view(unit) == "%";  // of which a tenth of a per cent is told
  if (value && std::abs(*difference) < (ratio ? 5e-4 : kSame * std::abs(*value))) return "same";
  const std::string text = shown(difference, unit);
  if (text.front() == '0' && text.find_first_of("123456789") == std::string::npos) return "same";
  return fmt::format("{}{}", *difference > 0.0 ? "+" : "", text);
}

bool any_has(const Json& runs, const char* key) {
  for (const Json& run : runs)
    if (number_at(run, {key})) return true;
  return false;
}

void add_run(Html& page, const Json& runs, const Json& run) {
  const Json& pass = value_at(run, {"pass"});
  const bool known = pass.is_boolean(), good = known && pass.get<bool>();
  page.open("tr").element("td",
                          !known ? "–"
                          : good ? "✓"
                                 : "✗",
                          {{"class", !known ? "mark"
                                     : good ? "mark good"
                                            : "mark bad"}});
  std::string label = text_at(run, {"label"});
  if (label.empty()) label = spaced(text_at(run, {"name"}));
  page.open("td", {{"class", "head"}}).element("b", label).close();
  for (const Column& column : kColumns) {
    if (!any_has(runs, column.key)) continue;
    page.open("td", {{"class", "n"}, {"data-label", column.head}});
    page.text(shown(number_at(run, {column.key}), column.unit));
    const std::string by = difference_words(number_at(run, {"difference", column.key}),
                                            number_at(run, {column.key}), column.unit);
    if (!by.empty()) page.element("small", by);
    page.close();
  }
  page.close();
}

}  // namespace

std::string numerics_words(const Json& numerics) {
  const Json& agree = value_at(numerics, {"agree"});
  if (!agree.is_boolean()) return "";
  std::string out =
      agree.get<bool>()
          ? "All agree: the verdict does not hang on how the physics is computed."
          : "They do not agree: part of what was measured comes from how the physics is computed.";
  const Json& reasons = value_at(numerics, {"reasons"});
  if (reasons.is_array())
    for (const Json& reason : reasons)
      if (reason.is_string()) out += fmt::format(" {}.", reason.get<std::string>());
  return out;
}

void add_numerics(Html& page, const RunData& data) {
  page.open("section").element("h2", "Second opinion");
  const Json& runs = value_at(data.numerics, {"runs"});
  if (!runs.is_array() || runs.empty()) {
    add_hint(page, "The gait has not been played with other numerics yet.", "validate", data);
    page.close();
    return;
  }
  page.element("p",
               "The same gait with a finer time step, another integrator and another model of "
               "friction. " +
                   numerics_words(data.numerics));
  page.open("table", {{"class", "limits stack"}}).open("thead").open("tr");
  page.element("th", "").element("th", "");
  for (const Column& column : kColumns)
    if (any_has(runs, column.key)) page.element("th", column.head, {{"class", "n"}});
  page.close().close().open("tbody");
  for (std::size_t k = 0; k < std::min(runs.size(), kMostRuns); ++k) add_run(page, runs, runs[k]);
  page.close().close();
  page.element("p", "Below each number: its difference from the first row.", {{"class", "note"}});
  page.close();
}

}  // namespace legwright
