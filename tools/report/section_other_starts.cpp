// SPDX-License-Identifier: Apache-2.0
// How unique the result is: where other starts ended, with their bodies side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/report/parameter_view.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr double kSameBody = 0.02;  // of the range: parameters closer than that are the same

/// The runs of all starts that came to a number, the least F first.
std::vector<const StartRecord*> by_cost(const RunRecord& run) {
  std::vector<const StartRecord*> out;
  if (run.starts)
    for (const StartRecord& start : *run.starts)
      if (std::isfinite(start.F)) out.push_back(&start);
  std::stable_sort(out.begin(), out.end(),
                   [](const auto* a, const auto* b) { return a->F < b->F; });
  return out;
}

/// By how much the bodies differ in a parameter, as a share of its range.
double spread_of(const ParameterView& p, const std::vector<const StartRecord*>& starts) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const StartRecord* start : starts)
    if (const double* const value = start->s.find(p.name)) {
      least = std::min(least, *value);
      most = std::max(most, *value);
    }
  return most > least && p.upper > p.lower ? (most - least) / (p.upper - p.lower) : 0.0;
}

}  // namespace

std::string other_starts_words(const RunRecord& run) {
  const std::vector<const StartRecord*> starts = by_cost(run);
  if (starts.size() < 2 || !(starts.front()->F > 0.0)) return "";
  const std::size_t others = starts.size() - 1;
  std::size_t differing = 0, all = 0;
  for (const ParameterView& p : parameters_of(run)) {
    ++all;
    differing += spread_of(p, starts) > kSameBody ? 1 : 0;
  }
  const double worse = starts.back()->F / starts.front()->F - 1.0;
  return fmt::format(
      "{} other start{} end{} within {} of the least F; their bodies differ in {} of {} parameters "
      "by more than 2 % of the range.",
      others, others == 1 ? "" : "s", others == 1 ? "s" : "", percent_whole(worse), differing, all);
}

void add_other_starts(Html& page, const RunRecord& run) {
  const std::string words = other_starts_words(run);
  if (words.empty()) return;
  const std::vector<const StartRecord*> starts = by_cost(run);
  page.open("section").element("h2", "How unique the result is").element("p", words);
  std::vector<TableColumn> columns{{""}};
  for (const StartRecord* start : starts) columns.push_back({"from " + spaced(start->start), "n"});
  page.open("div", {{"class", "scroll"}}).open_table("design bodies", columns);
  page.open("tr").open("td").element("b", "F").close();
  for (const StartRecord* start : starts)
    page.number(three_digits(start->F), "from " + spaced(start->start));
  page.close();
  for (const ParameterView& p : parameters_of(run)) {
    if (spread_of(p, starts) <= kSameBody) continue;
    page.open("tr").open("td").element("b", spaced(p.name)).close();
    for (const StartRecord* start : starts) {
      const double* const value = start->s.find(p.name);
      page.number(value != nullptr ? p.with_unit(*value) : "–", "from " + spaced(start->start));
    }
    page.close();
  }
  page.close().close().close();
  page.note(
      "The least F first. Where bodies differ much at nearly one F, the task leaves that parameter "
      "open, and other wishes may decide it.");
  page.close();
}

}  // namespace legwright
