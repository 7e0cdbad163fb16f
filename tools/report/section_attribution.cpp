// SPDX-License-Identifier: Apache-2.0
// Why the body changed: what each change buys in the finished body, by term of F (attribution), and
// all parameters with their bounds.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "tools/report/attribution_words.hpp"
#include "tools/report/changed_parameters.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/svg_bars.hpp"
#include "tools/report/words.hpp"
#include "tools/run/attribution_json.hpp"

namespace legwright {
namespace {

constexpr std::size_t kFewParameters = 6;  // so many are shown without unfolding
constexpr std::size_t kMostTold = 4;       // of the largest changes

/// Why a parameter changed, in words; empty where it is not known.
using Reason = std::function<std::string(const std::string& parameter)>;

void add_table(Html& page, const std::vector<ParameterView>& parameters, bool angles,
               const Reason& reason) {
  if (std::none_of(parameters.begin(), parameters.end(),
                   [&](const auto& p) { return p.angle == angles; }))
    return;
  page.element("h3", angles ? "Joint axes" : "Lengths");
  page.open("div", {{"class", "scroll"}})
      .open_table("design",
                  {{"", ""}, {"before", "n"}, {"after", "n"}, {"change", "n"}, {"within bounds"}});
  for (const ParameterView& p : parameters) {
    if (p.angle != angles) continue;
    page.open("tr").open("td").element("b", spaced(p.name));
    if (!p.sentence.empty()) page.element("small", p.sentence);
    if (const std::string why = reason(p.name); !why.empty())
      page.element("small", "Why: " + why, {{"class", "why"}});
    page.close();
    page.number(p.with_unit(p.initial), "before");
    page.open("td", {{"class", "n"}, {"data-label", "after"}}).text(p.with_unit(p.final));
    if (angles) page.element("small", p.in_radian(p.final));
    page.close().number(p.change(), "change");
    page.open("td", {{"class", "bar"}}).raw(bounds_bar(p.lower, p.upper, p.initial, p.final));
    page.open("small").text(p.with_unit(p.lower) + " … " + p.with_unit(p.upper));
    if (!p.at_bound().empty()) page.element("em", fmt::format("at its {}", p.at_bound()));
    page.close().close().close();
  }
  page.close().close().close();
}

void add_largest(Html& page, const ChangedParameters& changed) {
  page.note(changed.by_cost ? "The changes that buy most:"
                            : "The largest changes, by share of the allowed range:");
  page.open("ol", {{"class", "changes"}});
  for (std::size_t i = 0; i < std::min(kMostTold, changed.list.size()); ++i) {
    const auto& [p, lowered, played] = changed.list[i];
    page.open("li").element("b", fmt::format("{} {}", spaced(p.name), p.change()));
    page.text(fmt::format(", from {} to {}", p.with_unit(p.initial), p.with_unit(p.final)));
    if (!p.at_bound().empty()) page.text(", at its " + p.at_bound());
    if (changed.by_cost) page.text("; " + put_back_words(lowered, played));
    page.close();
  }
  page.close();
  if (const std::string bound = changed.bound_words(); !bound.empty()) page.element("p", bound);
}

/// A sentence on all parameters, and how to read the numbers.
void add_why(Html& page, const RunData& data, const std::vector<Attribution>& attributions) {
  const bool part = data.run.joint_run.has_value();
  const std::string summary =
      attribution_summary(attributions, part ? std::nullopt : data.run.fall_of_cost());
  if (summary.empty()) return;
  const std::string physics = put_back_physics_words(data.run.put_back);
  page.open("p").element("b", "Why it changed. ");
  page.text(physics.empty() ? summary : summary + " " + physics).close();
  page.note(kPutBackNote);
  if (part) page.note("They are of this task alone; the body serves others, too.");
  add_gap_note(page, data.run, "They are");
}

struct TermRow {
  std::string name;
  double before = 0.0, after = 0.0;
};

void add_term_bar(Html& page, double value, double most, const char* style) {
  const double width = most > 0.0 ? 100.0 * std::clamp(value / most, 0.0, 1.0) : 0.0;
  page.raw(
      fmt::format("<svg class=\"share\" viewBox=\"0 0 100 8\" preserveAspectRatio=\"none\" "
                  "aria-hidden=\"true\">"
                  "<rect class=\"{}\" width=\"{:.2f}\" height=\"8\"/></svg>",
                  style, width));
}

void open_terms(Html& page) {
  page.open_table("terms stack", {{""}, {"before", "n"}, {"after", "n"}, {""}});
}

void add_term(Html& page, const TermRow& row, double most) {
  page.open("tr").open("td", {{"class", "head"}});
  page.element("b", term_words(row.name)).element("small", row.name).close();
  page.number(short_number(row.before), "before");
  page.number(short_number(row.after), "after");
  page.open("td", {{"class", "bars"}});
  add_term_bar(page, row.before, most, "b2");
  add_term_bar(page, row.after, most, "b1");
  page.close().close();
}

}  // namespace

void add_attribution(Html& page, const RunData& data) {
  page.element("h3", "What changed in the body");
  const auto parameters = parameters_of(data.run);
  if (parameters.empty()) {
    page.note("run.json lists no design parameters.");
    return;
  }
  add_largest(page, changed_parameters(data.run));
  const auto attributions = attributions_of(data.run.put_back);
  add_why(page, data, attributions);
  const Reason reason = [&, scale = largest_share(attributions)](const std::string& parameter) {
    for (const Attribution& each : attributions)
      if (each.parameter == parameter) return attribution_words(each, scale);
    return std::string();
  };
  const bool few = parameters.size() <= kFewParameters;
  if (!few)
    page.open("details").element(
        "summary", fmt::format("All {} parameters: before, after, bounds, why", parameters.size()));
  add_table(page, parameters, true, reason);
  add_table(page, parameters, false, reason);
  if (!few) page.close();
}

void add_terms(Html& page, const RunData& data) {
  if (data.iterations.empty()) return;
  const IterationEvent &first = data.iterations.front(), &last = data.iterations.back();
  std::vector<TermRow> rows;
  double most = 0.0;
  for (const auto& [name, value] : first.terms) {
    const double* const after = last.terms.find(name);
    rows.push_back({name, value, after != nullptr ? *after : 0.0});
    most = std::max({most, rows.back().before, rows.back().after});
  }
  std::erase_if(rows, [](const TermRow& row) { return row.before == 0.0 && row.after == 0.0; });
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.before > b.before; });
  const auto small = std::stable_partition(rows.begin(), rows.end(), [&](const TermRow& row) {
    return row.before > kSmallTerm * first.F || row.after > kSmallTerm * last.F;
  });
  const bool alone = motion_only(data);  // both columns would be the same
  page.open("section", {{"class", alone ? "only" : ""}}).element("h2", "What the cost is made of");
  page.note(alone ? "Each term of F, weighted."
                  : "Each term of F, weighted, for the initial body and for the co-designed one.");
  add_gap_note(page, data.run, "The terms are");
  if (!alone)
    page.raw(
        "<p class=\"legend\"><span><i class=\"key b2\"></i>before</span> <span><i class=\"key "
        "b1\"></i>after</span></p>\n");
  open_terms(page);
  for (auto row = rows.begin(); row != small; ++row) add_term(page, *row, most);
  page.open("tr", {{"class", "sum"}}).element("td", "F", {{"class", "head"}});
  page.number(short_number(first.F), "before");
  page.number(short_number(last.F), "after");
  page.element("td", "").close().close().close();
  if (small != rows.end()) {
    page.open("details").element(
        "summary", fmt::format("{} more terms, each below 1 % of F", rows.end() - small));
    open_terms(page);
    for (auto row = small; row != rows.end(); ++row) add_term(page, *row, most);
    page.close().close().close();
  }
  page.close();
}

}  // namespace legwright
