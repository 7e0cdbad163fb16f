// SPDX-License-Identifier: Apache-2.0
// What is proven of the result: certificate.json in words and tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/number_words.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

using Tasks = ByName<TaskCertificateRecord>;

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
  page.element("td", claim).number(number).close();
}

/// " of pace", where there are several tasks.
std::string of_task(const Tasks& tasks, const std::string& name) {
  return tasks.size() > 1 ? " of " + spaced(name) : "";
}

void add_motion_claims(Html& page, const Tasks& tasks) {
  for (const auto& [name, task] : tasks) {
    add_claim(page, task.motion_status == "converged",
              "The motion" + of_task(tasks, name) + " is at rest: ‖∂F/∂m‖, its largest entry",
              short_number(task.stationarity));
    add_claim(page, task.motion_hessian_positive,
              "and at a minimum: all curvatures of F along the motion are positive",
              task.motion_hessian_positive ? "yes" : "no");
  }
}

void add_design_claims(Html& page, const RunData& data) {
  const CertificateRecord& proof = *data.certificate;
  add_claim(page, data.run.status == "converged",
            "The body is at rest within its bounds: projected ‖dF/ds‖",
            short_number(proof.projected_gradient_norm));
  const std::vector<double>& list = proof.design_curvatures;
  const bool known = !list.empty();
  const auto [least, most] = std::minmax_element(list.begin(), list.end());
  add_claim(page, known ? std::optional(*least > 0.0) : std::nullopt,
            known ? fmt::format("and at a minimum: curvatures in its {} free directions, least and "
                                "most",
                                list.size())
                  : "and at a minimum: its curvatures are not known",
            known ? short_number(*least) + " … " + short_number(*most) : "–");
  add_claim(page, proof.worst_gradient_error < kGradientRight,
            "The gradient is right: largest error of the adjoint against central differences, as a "
            "share of the gradient",
            short_number(proof.worst_gradient_error));
}

constexpr double kMoreRoom = 0.1;  // of the allowed range
constexpr double kDecides = 0.01;  // of the cost: from here on a bound is worth widening

/// A bound that the body stands at, and by how much the cost would fall with more room there, to
/// first order.
struct DecidingBound {
  const ParameterView* parameter;
  bool upper;
  double gain;
};

/// Those of known parameters, what would gain most first.
std::vector<DecidingBound> deciding_bounds(const std::vector<ActiveBoundRecord>& active,
                                           const std::vector<ParameterView>& parameters) {
  std::vector<DecidingBound> out;
  for (const ActiveBoundRecord& bound : active) {
    const ParameterView* const found = find_named(parameters, bound.parameter);
    if (found == nullptr) continue;
    const bool upper = bound.bound == "upper";
    const double room = kMoreRoom * (found->upper - found->lower);
    out.push_back({found, upper, (upper ? -1.0 : 1.0) * bound.gradient * room});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return a.gain > b.gain; });
  return out;
}

/// "stands at its upper bound, 200.0 mm; up to 212.0 mm would lower F by about 0.013."
/// @param cost what the body minimises: F, or F + J
std::string bound_words(const DecidingBound& bound, std::string_view cost) {
  const ParameterView& p = *bound.parameter;
  const double room = kMoreRoom * (p.upper - p.lower);
  return fmt::format(
      "stands at its {} bound, {}; {} {} would {} {} by about {}.", bound.upper ? "upper" : "lower",
      p.with_unit(bound.upper ? p.upper : p.lower), bound.upper ? "up to" : "down to",
      p.with_unit(bound.upper ? p.upper + room : p.lower - room),
      bound.gain < 0.0 ? "raise" : "lower", cost, short_number(std::abs(bound.gain)));
}

void add_bounds(Html& page, const RunData& data, const std::vector<ParameterView>& parameters) {
  page.element("h3", "What holds the body back");
  if (data.certificate->active_bounds.empty()) {
    page.element("p", "No parameter presses against its bounds.");
    return;
  }
  const std::string_view cost = data.run.outer ? "F + J" : "F";
  const double least = kDecides * std::abs(data.run.final_F.value_or(0.0));
  std::string widen;
  page.open("ul", {{"class", "changes"}});
  for (const DecidingBound& bound : deciding_bounds(data.certificate->active_bounds, parameters)) {
    page.open("li").element("b", spaced(bound.parameter->name));
    page.text(" " + bound_words(bound, cost)).close();
    if (bound.gain >= least && least > 0.0)
      widen += (widen.empty() ? "" : ", ") + spaced(bound.parameter->name);
  }
  page.close();
  page.note(
      "Each with 10 % of its range more room, by the gradient at the bound: of a longer way less.");
  if (!widen.empty())
    page.element("p", "Worth more room, if the robot can be built so: " + widen +
                          ". Bounds stand in the robot's file and, narrower, in the task's "
                          "[design.bounds].");
}

void add_violation(Html& page, const ViolationRecord& row) {
  const bool met = row.amount < 0.0;  // an inequality, and this far from its wall
  page.open("tr").open("td", {{"class", "head"}}).element("b", term_words(row.term));
  const bool numbered = !row.equation.empty() && row.equation != "-";
  page.element("small", spaced(row.term) + (numbered ? " " + row.equation : ""));
  page.close();
  const std::string by = quantity_words(std::abs(row.amount), row.unit);
  page.number(met ? by + " to spare" : by, "off by");
  page.number(met                   ? "–"
              : row.relative < 5e-4 ? "below 0.1 %"
                                    : percent(row.relative),
              "of its scale");
  page.open("td", {{"data-label", "where"}})
      .text(row.where.empty() ? "whole robot" : spaced(row.where));
  page.text(fmt::format(", at {:.2f} s", row.time));
  page.close().close();
}

void add_violations(Html& page, const Tasks& tasks) {
  for (const auto& [name, task] : tasks) {
    if (task.violations.empty()) continue;
    page.open("details").element(
        "summary",
        "Each constraint at its worst" + (tasks.size() > 1 ? ", " + spaced(name) : std::string()));
    page.open_table("worst stack",
                    {{"constraint"}, {"off by", "n"}, {"of its scale", "n"}, {"where"}});
    for (const ViolationRecord& row : task.violations) add_violation(page, row);
    page.close().close();
    page.note(
        "Constraints are penalties in F, so small remainders are normal; where one is met, the "
        "table says how much room is left at its tightest.");
    page.close();
  }
}

void add_gradient(Html& page, const Tasks& tasks, const std::vector<ParameterView>& parameters) {
  for (const auto& [name, task] : tasks) {
    if (task.design_gradient.empty()) continue;
    page.open("details").element(
        "summary", fmt::format("The gradient{}, parameter by parameter", of_task(tasks, name)));
    if (!task.motions_resolved) {
      page.note(
          "Some of the motions that the differences were taken from came to rest only "
          "roughly; their differences are less exact.");
    }
    page.open("div", {{"class", "scroll"}})
        .open_table("gradient",
                    {{"dF/ds by"}, {"adjoint", "n"}, {"central difference", "n"}, {"error", "n"}});
    for (const auto& [parameter, row] : task.design_gradient) {
      const ParameterView* const found = find_named(parameters, parameter);
      const char* unit = found == nullptr ? "" : found->angle ? ", per rad" : ", per m";
      page.open("tr").element("td", spaced(parameter) + unit);
      page.number(long_number(row.adjoint));
      page.number(long_number(row.difference));
      page.number(short_number(row.error)).close();
    }
    page.close().close().close();
    page.note(
        "Errors are in F per natural unit of the parameter: its initial length, or one radian.");
    page.close();
  }
}

}  // namespace

void add_certificate(Html& page, const RunData& data) {
  page.open("section").element("h2", "Certificate");
  if (!data.certificate) {
    page.open("p", {{"class", "hint"}})
        .text("Nothing has been proven of this result: result/certificate.json is not there. ")
        .element("code", "legwright optimize")
        .text(" writes it at its end, unless told --no-certificate.")
        .close()
        .close();
    return;
  }
  const Tasks& tasks = data.certificate->tasks;
  page.note(std::string("Checked after the optimisation, with every derivative taken anew. ") +
            (data.run.joint_run ? "What is said of the body is about the weighted sum of all tasks."
                                : ""));
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
