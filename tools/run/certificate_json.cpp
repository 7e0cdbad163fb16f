// SPDX-License-Identifier: Apache-2.0
#include "tools/run/certificate_json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace legwright {
namespace {

// A constraint broken by less than this share of its own scale is met, as far as penalties go.
constexpr double kMet = 1e-3;

std::vector<ViolationRecord> violations_of(const Objective& objective, const Eigen::VectorXd& s,
                                           const Eigen::VectorXd& m) {
  std::vector<ViolationRecord> rows;
  for (const Violation& v : worst_violations(objective, s, m))
    rows.push_back({std::string(v.term), std::string(v.equation), v.where, v.knot,
                    v.knot * objective.task().gait.time_step(), v.amount, std::string(v.unit),
                    v.relative});
  return rows;
}

TaskCertificateRecord certificate_of_task(const CodesignProblem& problem,
                                          const DesignIteration& iterate, const Certificate& proof,
                                          int task) {
  const TaskCertificate& own = proof.tasks[task];
  TaskCertificateRecord record;
  record.stationarity = own.stationarity;
  record.motion_status = to_string(own.motion_status);
  record.motion_hessian_positive = own.minimum_in_motion;
  record.adjoint_residual = own.adjoint_residual;
  record.motions_resolved = own.resolved;
  for (int k = 0; k < own.adjoint.size(); ++k)
    record.design_gradient.of(problem.robot.space.parameters[k].name) = {
        own.adjoint[k], own.difference[k], own.error[k]};
  record.violations = violations_of(*problem.objectives[task], iterate.s, iterate.tasks[task].m);
  return record;
}

std::string quantity(double amount, std::string_view unit) {
  if (unit == "m") return fmt::format("{:.3g} mm", 1e3 * amount);
  if (unit.empty()) return fmt::format("{:.3g}", amount);
  return fmt::format("{:.3g} {}", amount, unit);
}

}  // namespace

CertificateRecord certificate_record(const CodesignProblem& problem, const DesignIteration& iterate,
                                     const Certificate& proof, const std::vector<int>& tasks) {
  CertificateRecord record;
  record.projected_gradient_norm = proof.projected_gradient_norm;
  record.worst_gradient_error = proof.worst_gradient_error();
  record.design_curvatures.assign(proof.curvatures.begin(), proof.curvatures.end());
  for (const ActiveBound& bound : proof.active)
    record.active_bounds.push_back({problem.robot.space.parameters[bound.parameter].name,
                                    bound.upper ? "upper" : "lower", bound.gradient});
  for (int task : tasks)
    record.tasks.of(problem.task(task).name) = certificate_of_task(problem, iterate, proof, task);
  return record;
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
