// SPDX-License-Identifier: Apache-2.0
#include "tools/run/certificate_json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace legwright {
namespace {

// A constraint broken by less than this share of its own scale is met, as far as penalties go.
constexpr double kMet = 1e-3;

Json violations_json(const Objective& objective, const Eigen::VectorXd& s,
                     const Eigen::VectorXd& m) {
  Json rows = Json::array();
  for (const Violation& violation : worst_violations(objective, s, m))
    rows.push_back({{"term", violation.term},
                    {"equation", violation.equation},
                    {"where", violation.where},
                    {"knot", violation.knot},
                    {"time_s", violation.knot * objective.task().gait.time_step()},
                    {"amount", violation.amount},
                    {"unit", violation.unit},
                    {"relative", violation.relative}});
  return rows;
}

Json gradient_json(const DesignSpace& space, const TaskCertificate& proof) {
  Json rows = Json::object();
  for (int k = 0; k < proof.adjoint.size(); ++k)
    rows[space.parameters[k].name] = {{"adjoint", proof.adjoint[k]},
                                      {"difference", proof.difference[k]},
                                      {"error", proof.error[k]}};
  return rows;
}

Json task_json(const CodesignProblem& problem, const DesignIteration& iterate,
               const Certificate& proof, int task) {
  const TaskCertificate& own = proof.tasks[task];
  return {
      {"stationarity", own.stationarity},
      {"motion_status", to_string(own.motion_status)},
      {"motion_hessian_positive", own.minimum_in_motion},
      {"adjoint_residual", own.adjoint_residual},
      {"motions_resolved", own.resolved},
      {"design_gradient", gradient_json(problem.robot.space, own)},
      {"violations", violations_json(*problem.objectives[task], iterate.s, iterate.tasks[task].m)}};
}

std::string quantity(double amount, std::string_view unit) {
  if (unit == "m") return fmt::format("{:.3g} mm", 1e3 * amount);
  if (unit.empty()) return fmt::format("{:.3g}", amount);
  return fmt::format("{:.3g} {}", amount, unit);
}

}  // namespace

Json certificate_json(const CodesignProblem& problem, const DesignIteration& iterate,
                      const Certificate& proof, const std::vector<int>& tasks) {
  const DesignSpace& space = problem.robot.space;
  Json active = Json::array(), by_task = Json::object();
  for (const ActiveBound& bound : proof.active)
    active.push_back({{"parameter", space.parameters[bound.parameter].name},
                      {"bound", bound.upper ? "upper" : "lower"},
                      {"gradient", bound.gradient}});
  for (int task : tasks)
    by_task[problem.task(task).name] = task_json(problem, iterate, proof, task);
  const auto& curvatures = proof.curvatures;
  return {{"schema", "legwright/certificate"},
          {"version", 1},
          {"projected_gradient_norm", proof.projected_gradient_norm},
          {"worst_gradient_error", proof.worst_gradient_error()},
          {"design_curvatures", std::vector<double>(curvatures.begin(), curvatures.end())},
          {"active_bounds", active},
          {"tasks", by_task}};
}

std::string in_words(const Violation& violation, const Objective& objective) {
  const double time = violation.knot * objective.task().gait.time_step();
  std::string text(violation.term);
  for (char& c : text)
    if (c == '_') c = ' ';
  if (violation.equation != "-") text += fmt::format(" {}", violation.equation);
  text += " is broken most";
  if (!violation.where.empty()) text += fmt::format(" by {}", violation.where);
  return text +
         fmt::format(" at {:.3g} s, by {}", time, quantity(violation.amount, violation.unit));
}

std::vector<std::string> worst_constraints(const Objective& objective, const Eigen::VectorXd& s,
                                           const Eigen::VectorXd& m, int count) {
  std::vector<std::string> words;
  for (const Violation& violation : worst_violations(objective, s, m)) {
    if (static_cast<int>(words.size()) == count || violation.relative <= kMet) break;
    words.push_back(in_words(violation, objective));
  }
  return words;
}

}  // namespace legwright
