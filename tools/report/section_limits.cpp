// SPDX-License-Identifier: Apache-2.0
// What the verdict is made of: each limit with what was measured.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

/// Shares and ratios in per cent, the rest in its unit.
std::string value_words(const LimitRow& row, std::optional<double> value) {
  for (const char* part : {"share", "ratio", "survival"})
    if (row.unit == "1" && row.name.find(part) != std::string::npos) return percent(value);
  return amount_words(value, row.unit);
}

void add_row(Html& page, const LimitRow& row) {
  page.open("tr", {{"class", row.pass ? "" : "failed"}});
  page.element("td", row.pass ? "✓" : "✗", {{"class", row.pass ? "mark good" : "mark bad"}});
  page.open("td", {{"class", "head"}});
  page.element("b", row.what.empty() ? spaced(row.name) : row.what);
  page.close();
  page.element("td", measured_words(row), {{"class", "n"}, {"data-label", "measured"}});
  page.element("td", bound_words(row), {{"class", "n"}, {"data-label", "limit"}});
  page.element("td", row.where.empty() ? "–" : spaced(row.where), {{"data-label", "worst at"}});
  page.close();
}

void add_table(Html& page, const std::vector<LimitRow>& rows) {
  page.open("table", {{"class", "limits stack"}}).open("thead").open("tr");
  page.element("th", "").element("th", "");
  page.element("th", "measured", {{"class", "n"}}).element("th", "limit", {{"class", "n"}});
  page.element("th", "worst at").close().close().open("tbody");
  for (const LimitRow& row : rows) add_row(page, row);
  page.close().close();
}

}  // namespace

std::string measured_words(const LimitRow& row) {
  return row.value ? value_words(row, row.value) : "not measured";
}

std::string bound_words(const LimitRow& row) {
  if (row.low && row.high)
    return (row.strict ? "strictly within " : "") + value_words(row, row.low) + " … " +
           value_words(row, row.high);
  if (row.low) return (row.strict ? "more than " : "at least ") + value_words(row, row.low);
  if (row.high == 0.0 && !row.strict) return "none";
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

void add_limits(Html& page, const RunData& data) {
  page.open("section").element("h2", "Limits");
  const auto &after = data.limits_result, &before = data.limits_initial;
  if (after.empty() && before.empty()) {
    add_hint(page,
             data.verdict.is_null() ? "Nothing has been measured against the limits yet."
                                    : "verdict.json does not list the limits one by one.",
             "validate", data);
    page.close();
    return;
  }
  if (!after.empty()) {
    page.element("p", limits_kept(after) +
                          " A verdict passes where all are; each is taken at its worst over the "
                          "servo gains that were played.");
    add_table(page, after);
  }
  if (!before.empty() && !motion_only(data)) {
    page.open("details").element("summary", "The same before the body changed");
    page.element("p", limits_kept(before));
    add_table(page, before);
    page.close();
  }
  page.close();
}

}  // namespace legwright
