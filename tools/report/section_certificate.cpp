// SPDX-License-Identifier: Apache-2.0
// What is proven of the result: certificate.json in words and tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr double kGradientRight = 1e-4;  // error of the adjoint, of the gradient's largest entry

/// A statement, whether it holds, and the number that says so.
void add_claim(Html& page, std::optional<bool> holds, const std::string& claim,
               const std::string& number) {
  page.open("tr").element("td",
                          !holds   ? "–"
                          : *holds ? "✓"
                                   : "✗",
                          {{"class", !holds   ? "mark"
                                     : *holds ? "mark good"
                                              : "mark bad"}});
  page.element("td", claim).element("td", number, {{"class", "n"}}).close();
}

std::optional<bool> flag_at(const Json& json, const char* key) {
  const Json& value = value_at(json, {key});
  return value.is_boolean() ? std::optional(value.get<bool>()) : std::nullopt;
}

/// " of pace", where there are several tasks.
std::string of_task(const Json& tasks, const std::string& name) {
  return tasks.size() > 1 ? " of " + spaced(name) : "";
}

void add_motion_claims(Html& page, const Json& tasks) {
  for (const auto& [name, task] : tasks.items()) {
    const auto rest = number_at(task, {"stationarity"});
    const std::string status = text_at(task, {"motion_status"});
    add_claim(page, status.empty() ? std::nullopt : std::optional(status == "converged"),
              "The motion" + of_task(tasks, name) + " is at rest: ‖∂F/∂m‖, its largest entry",
              short_number(rest));
    const auto positive = flag_at(task, "motion_hessian_positive");
    add_claim(page, positive, "and at a minimum: all curvatures of F along the motion are positive",
              !positive   ? "–"
              : *positive ? "yes"
                          : "no");
  }
}

/// Least and most of the design's curvatures; nothing without numbers.
std::optional<std::pair<double, double>> curvatures_of(const Json& list) {
  std::optional<std::pair<double, double>> range;
  if (!list.is_array()) return range;
  for (const Json& value : list) {
    if (!value.is_number()) continue;
    const double v = value.get<double>();
    range =
        range ? std::pair(std::min(range->first, v), std::max(range->second, v)) : std::pair(v, v);
  }
  return range;
}

void add_design_claims(Html& page, const RunData& data) {
  const Json& proof = data.certificate;
  const std::string status = text_at(data.run, {"status"});
  add_claim(page, status.empty() ? std::nullopt : std::optional(status == "converged"),
            "The body is at rest within its bounds: projected ‖dF/ds‖",
            short_number(number_at(proof, {"projected_gradient_norm"})));
  const Json& list = value_at(proof, {"design_curvatures"});
  const auto range = curvatures_of(list);
  add_claim(page, range ? std::optional(range->first > 0.0) : std::nullopt,
            range ? fmt::format("and at a minimum: curvatures in its {} free directions, least and "
                                "most",
                                list.size())
                  : "and at a minimum: its curvatures are not known",
            range ? short_number(range->first) + " … " + short_number(range->second) : "–");
  const auto error = number_at(proof, {"worst_gradient_error"});
  add_claim(page, error ? std::optional(*error < kGradientRight) : std::nullopt,
            "The gradient is right: largest error of the adjoint against central differences, as a "
            "share of the gradient",
            short_number(error));
}

/// "body width stands at its upper bound; 1 cm more would lower F by about 0.013."
/// @param cost what the body minimises: F, or F + J
std::string bound_words(const Json& active, const std::vector<ParameterView>& parameters,
                        std::string_view cost) {
  const std::string name = text_at(active, {"parameter"}), bound = text_at(active, {"bound"});
  const auto gradient = number_at(active, {"gradient"});
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const ParameterView& p) { return p.name == name; });
  if (found == parameters.end() || !gradient) return "";
  const bool upper = bound == "upper";
  std::string out = fmt::format("stands at its {} bound, {}", upper ? "upper" : "lower",
                                found->with_unit(upper ? found->upper : found->lower));
  const double step = found->angle ? 0.0872664625997165 : 0.01;  // 5° or 1 cm
  const double change = (upper ? 1.0 : -1.0) * *gradient * step;
  return out + fmt::format("; {} {} would {} {} by about {}.", found->angle ? "5°" : "1 cm",
                           upper ? "more" : "less", change < 0.0 ? "lower" : "raise", cost,
                           short_number(std::abs(change)));
}

void add_bounds(Html& page, const RunData& data, const std::vector<ParameterView>& parameters) {
  const Json& active = value_at(data.certificate, {"active_bounds"});
  page.element("h3", "What holds the body back");
  if (!active.is_array() || active.empty()) {
    page.element("p", "No parameter presses against its bounds.");
    return;
  }
  const bool outer = value_at(data.run, {"outer"}).is_object();
  const std::string_view cost = outer ? "F + J" : "F";
  page.open("ul", {{"class", "changes"}});
  for (const Json& bound : active) {
    const std::string words = bound_words(bound, parameters, cost);
    if (words.empty()) continue;
    page.open("li").element("b", spaced(text_at(bound, {"parameter"}))).text(" " + words).close();
  }
  page.close();
}

void add_violation(Html& page, const Json& row) {
  const auto amount = number_at(row, {"amount"}), time = number_at(row, {"time_s"}),
             relative = number_at(row, {"relative"});
  const std::string term = text_at(row, {"term"}), where = text_at(row, {"where"}),
                    unit = text_at(row, {"unit"}), equation = text_at(row, {"equation"});
  const bool met = amount && *amount < 0.0;  // an inequality, and this far from its wall
  page.open("tr").open("td", {{"class", "head"}}).element("b", term_words(term));
  page.element("small", spaced(term) + (equation.empty() || equation == "-" ? "" : " " + equation));
  page.close();
  const std::string by = amount ? quantity_words(std::abs(*amount), unit) : "–";
  page.element("td", met ? by + " to spare" : by, {{"class", "n"}, {"data-label", "off by"}});
  page.element("td",
               met || !relative   ? "–"
               : *relative < 5e-4 ? "below 0.1 %"
                                  : percent(*relative),
               {{"class", "n"}, {"data-label", "of its scale"}});
  page.open("td", {{"data-label", "where"}}).text(where.empty() ? "whole robot" : spaced(where));
  if (time) page.text(fmt::format(", at {:.2f} s", *time));
  page.close().close();
}

void add_violations(Html& page, const Json& tasks) {
  for (const auto& [name, task] : tasks.items()) {
    const Json& rows = value_at(task, {"violations"});
    if (!rows.is_array() || rows.empty()) continue;
    page.open("details").element(
        "summary",
        "Each constraint at its worst" + (tasks.size() > 1 ? ", " + spaced(name) : std::string()));
    page.open("table", {{"class", "worst stack"}});
    page.open("thead").open("tr").element("th", "constraint");
    page.element("th", "off by", {{"class", "n"}});
    page.element("th", "of its scale", {{"class", "n"}});
    page.element("th", "where").close().close().open("tbody");
    for (const Json& row : rows) add_violation(page, row);
    page.close().close();
    page.element(
        "p",
        "Constraints are penalties in F, so small remainders are normal; where one is met, the "
        "table says how much room is left at its tightest.",
        {{"class", "note"}});
    page.close();
  }
}

void add_gradient(Html& page, const Json& tasks, const std::vector<ParameterView>& parameters) {
  for (const auto& [name, task] : tasks.items()) {
    const Json& rows = value_at(task, {"design_gradient"});
    if (!rows.is_object() || rows.empty()) continue;
    page.open("details").element(
        "summary", fmt::format("The gradient{}, parameter by parameter", of_task(tasks, name)));
    const auto resolved = flag_at(task, "motions_resolved");
    if (resolved && !*resolved) {
      page.element("p",
                   "Some of the motions that the differences were taken from came to rest only "
                   "roughly; their differences are less exact.",
                   {{"class", "note"}});
    }
    page.open("div", {{"class", "scroll"}}).open("table", {{"class", "gradient"}});
    page.open("thead").open("tr").element("th", "dF/ds by");
    for (const char* head : {"adjoint", "central difference", "error"})
      page.element("th", head, {{"class", "n"}});
    page.close().close().open("tbody");
    for (const auto& [parameter, row] : rows.items()) {
      const auto found = std::find_if(parameters.begin(), parameters.end(),
                                      [&](const ParameterView& p) { return p.name == parameter; });
      const char* unit = found == parameters.end() ? "" : found->angle ? ", per rad" : ", per m";
      page.open("tr").element("td", spaced(parameter) + unit);
      page.element("td", long_number(number_at(row, {"adjoint"})), {{"class", "n"}});
      page.element("td", long_number(number_at(row, {"difference"})), {{"class", "n"}});
      page.element("td", short_number(number_at(row, {"error"})), {{"class", "n"}}).close();
    }
    page.close().close().close();
    page.element(
        "p",
        "Errors are in F per natural unit of the parameter: its initial length, or one radian.",
        {{"class", "note"}});
    page.close();
  }
}

}  // namespace

void add_certificate(Html& page, const RunData& data) {
  page.open("section").element("h2", "Certificate");
  const Json& tasks = value_at(data.certificate, {"tasks"});
  if (!tasks.is_object()) {
    page.open("p", {{"class", "hint"}})
        .text("Nothing has been proven of this result: result/certificate.json is not there. ")
        .element("code", "legwright optimize")
        .text(" writes it at its end, unless told --no-certificate.")
        .close()
        .close();
    return;
  }
  const bool part = !value_at(data.run, {"joint_run"}).is_null();
  page.element("p",
               std::string("Checked after the optimisation, with every derivative taken anew. ") +
                   (part ? "What is said of the body is about the weighted sum of all tasks." : ""),
               {{"class", "note"}});
  add_gap_note(page, data.run, "It is");
  page.open("table", {{"class", "proof"}}).open("tbody");
  add_motion_claims(page, tasks);
  add_design_claims(page, data);
  page.close().close();
  const auto parameters = parameters_of(data.run);
  add_bounds(page, data, parameters);
  add_violations(page, tasks);
  add_gradient(page, tasks, parameters);
  page.close();
}

}  // namespace legwright
