// SPDX-License-Identifier: Apache-2.0
// The bodies of a joint run side by side, and which task changed which parameter.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/attribution_words.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/svg_bars.hpp"
#include "tools/report/words.hpp"
#include "tools/run/attribution_json.hpp"

namespace legwright {
namespace {

void add_value(Html& page, const ParameterView& p, const MatrixDesign& design) {
  const double* const value = design.s.find(p.name);
  page.open("td", {{"class", "n"}, {"data-label", spaced(design.name)}});
  page.text(value ? p.with_unit(*value) : "–");
  const std::string bound = value ? p.bound_of(*value) : "";
  if (!bound.empty()) page.element("small", bound, {{"class", "limit"}});
  page.close();
}

void add_bodies_table(Html& page, const JointData& data,
                      const std::vector<ParameterView>& parameters, bool angles) {
  if (std::none_of(parameters.begin(), parameters.end(),
                   [&](const auto& p) { return p.angle == angles; }))
    return;
  page.element("h3", angles ? "Joint axes" : "Lengths");
  std::vector<TableColumn> columns{{""}};
  for (const MatrixDesign& design : data.designs) columns.push_back({spaced(design.name), "n"});
  columns.push_back({"within bounds"});
  page.open("div", {{"class", "scroll"}}).open_table("design bodies", columns);
  for (const ParameterView& p : parameters) {
    if (p.angle != angles) continue;
    page.open("tr").open("td").element("b", spaced(p.name));
    if (!p.sentence.empty()) page.element("small", p.sentence);
    page.close();
    for (const MatrixDesign& design : data.designs) add_value(page, p, design);
    page.open("td", {{"class", "bar"}}).raw(bounds_bar(p.lower, p.upper, p.initial, p.final));
    page.element("small", p.with_unit(p.lower) + " … " + p.with_unit(p.upper));
    page.close().close();
  }
  page.close().close().close();
}

std::vector<Attribution> attributions_by_task(const JointData& data) {
  std::vector<Attribution> all;
  for (const JointTaskData& task : data.tasks)
    if (task.run)
      merge_attributions(
          all, attributions_of(task.run->run.put_back, task.name, task.task.weight.value_or(1.0)));
  return all;
}

/// Change of F that a parameter’s change buys a task; small ones as zero.
std::string change_or_zero(double decrease, double scale) {
  return std::abs(decrease) < 0.002 * scale ? "0" : change_of_cost(-decrease);
}

void add_attribution_rows(Html& page, const JointData& data,
                          const std::vector<Attribution>& attributions) {
  const double scale = largest_share(attributions);
  for (const Attribution& each : attributions) {
    page.open("tr").open("td").element("b", spaced(each.parameter)).close();
    for (const JointTaskData& task : data.tasks) {
      page.number(change_or_zero(each.total(task.name), scale), spaced(task.name));
    }
    const std::string words = attribution_words(each, scale);
    page.element("td", words.empty() ? "hardly anything" : words, {{"class", "reason"}}).close();
  }
}

}  // namespace

void add_bodies(Html& page, const JointData& data) {
  page.open("section").element("h2", "The bodies");
  const auto parameters = parameters_of(data.whole.run);
  if (parameters.empty()) {
    page.note("run.json lists no design parameters.").close();
    return;
  }
  page.note(
      "Each column is the best body for its tasks; the bar shows the way from the initial body to "
      "the common one.");
  add_bodies_table(page, data, parameters, true);
  add_bodies_table(page, data, parameters, false);
  page.close();
}

void add_task_attributions(Html& page, const JointData& data) {
  const auto attributions = attributions_by_task(data);
  const std::string summary = attribution_summary(attributions, data.whole.run.fall_of_cost());
  if (summary.empty()) return;
  page.open("section").element("h2", "Why the body changed").element("p", summary);
  page.note(std::string(kPutBackNote) + " Here it is the joint F, task by task.");
  std::vector<TableColumn> columns{{""}};
  for (const JointTaskData& task : data.tasks) columns.push_back({spaced(task.name), "n"});
  columns.push_back({"what it buys"});
  page.open_table("design pulls", columns);
  add_attribution_rows(page, data, attributions);
  page.close().close();
  add_fewest(page, data.whole.run);
  page.close();
}

}  // namespace legwright
