// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace legwright::bench {
namespace {

constexpr double kLine = 1.05;  // a steeper exponent is explained

std::string number(double value) {
  if (value >= 100.0) return fmt::format("{:.0f}", value);
  if (value >= 10.0) return fmt::format("{:.3g}", value);
  return fmt::format("{:.2f}", value);
}

/// As it was asked: without digits that mean nothing.
std::string wish(double value) { return fmt::format("{:g}", value); }

std::string paper_row(const Case& of) {
  const PaperRow& paper = *of.paper;
  return fmt::format("| {} | paper | {} | {} | {} | {} | {:.1f} | |", of.label, paper.parameters,
                     paper.motion_iterations, paper.design_iterations, paper.seconds,
                     1e3 * paper.seconds / paper.motion_iterations);
}

std::string our_row(const std::string& label, const std::string& what, int parameters,
                    const Json& run) {
  const double wall = run["wall_seconds"];
  const int newton = run["newton_iterations"], design = run["design_iterations"];
  return fmt::format("| {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.4f} |", label, what,
                     parameters, newton, design, wall, 1e3 * wall / std::max(1, newton),
                     run["F"].get<double>());
}

void add_table_one(const Json& cases_json, const std::vector<Case>& cases, Json& lines) {
  lines.push_back(
      "| robot, tasks | | parameters s + m | Newton iterations | design iterations | s | ms / "
      "Newton iteration | F |");
  lines.push_back("|---|---|---|---|---|---|---|---|");
  for (const Case& of : cases) {
    if (of.paper) lines.push_back(paper_row(of));
    const Json& run = cases_json[of.label]["codesign"];
    lines.push_back(our_row(of.label, "here", run["parameters"], run));
    if (run.contains("all_starts"))
      lines.push_back(our_row(of.label, "here, all starts", run["parameters"], run["all_starts"]));
  }
}

std::string verdict(const Figure& figure) {
  const double sign = figure.at_least ? -1.0 : 1.0;
  return sign * figure.measured <= sign * figure.goal ? "yes" : "no";
}

void add_figures(const std::vector<Group>& groups, Json& lines) {
  std::vector<Figure> figures;
  for (const Group& group : groups)
    figures.insert(figures.end(), group.figures.begin(), group.figures.end());
  std::vector<std::string> names;  // in the order of their first appearance
  for (const Figure& figure : figures)
    if (std::find(names.begin(), names.end(), figure.name) == names.end())
      names.push_back(figure.name);
  lines.push_back("| figure | on | goal | measured | reached |");
  lines.push_back("|---|---|---|---|---|");
  for (const std::string& name : names)
    for (const Figure& figure : figures) {
      if (figure.name != name) continue;
      const std::string bound = figure.at_least ? "≥ " : "≤ ";
      const std::string unit = figure.unit.empty() ? "" : " " + figure.unit;
      lines.push_back(fmt::format("| {} | {} | {}{}{} | {}{} | {} |", figure.name, figure.where,
                                  bound, wish(figure.goal), unit, number(figure.measured), unit,
                                  verdict(figure)));
    }
}

void add_notes(const std::vector<Group>& groups, Json& lines) {
  for (const Group& group : groups)
    for (const std::string& note : group.notes) {
      lines.push_back("");
      lines.push_back(note + ".");
    }
}

/// Milliseconds at each point, and the exponent.
void add_curves(const std::vector<Group>& groups, Json& lines) {
  bool first = true;
  for (const Group& group : groups)
    for (const Curve& curve : group.curves) {
      if (std::exchange(first, false)) {
        lines.push_back("");
        lines.push_back("| ms of | on | against | | exponent | steeper than a line, as |");
        lines.push_back("|---|---|---|---|---|---|");
      }
      std::vector<std::string> points;
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        points.push_back(fmt::format("{:g}: {}", curve.x[k], number(1e3 * curve.seconds[k])));
      const double exponent = curve.exponent();
      lines.push_back(fmt::format("| {} | {} | {} | {} | {:.2f} | {} |", curve.what, curve.where,
                                  curve.against, fmt::join(points, ", "), exponent,
                                  exponent > kLine ? curve.why_steep : ""));
    }
}

}  // namespace

Json markdown(const Json& result, const std::vector<Case>& cases,
              const std::vector<Group>& groups) {
  Json lines = Json::array();
  add_table_one(result["cases"], cases, lines);
  lines.push_back("");
  add_figures(groups, lines);
  add_notes(groups, lines);
  add_curves(groups, lines);
  const Json& machine = result["machine"];
  const auto text = [&](const char* key) { return machine[key].get<std::string>(); };
  lines.push_back("");
  lines.push_back(fmt::format(
      "Machine: {}, one core; g++ {}, {} build ({}); Eigen {}, factorisation {}; commit {}.",
      text("cpu"), text("compiler"), text("build_type"), text("flags"), text("eigen"),
      text("factor"), text("commit")));
  return lines;
}

}  // namespace legwright::bench
