// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/gradients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "optimizer/solve/certificate.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kDirections = 8;
constexpr double kStep = 1e-6;  // along a direction of length one, in natural units

/// A direction of length one in natural units; from raw bits, so that it is the same everywhere.
VectorXd random_direction(const VectorXd& units, std::mt19937_64& random) {
  VectorXd direction(units.size());
  for (double& value : direction) value = static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
  return (direction / std::max(direction.norm(), 1e-300)).cwiseProduct(units);
}

class Checker {
 public:
  Checker(const Objective& objective, const VectorXd& scale)
      : objective_(objective), scale_(scale), workspace_(objective.make_workspace()) {}

  /// Fills all but `adjoint`.
  void at(const VectorXd& s, const VectorXd& m, GradientCheck& check) {
    Evaluation here, low, high;
    evaluate(s, m, Order::design, here);
    std::mt19937_64 random(1);
    const VectorXd& units = objective_.motion_units();
    // A gradient that vanishes, as at m*, has no size of its own: then F's own size stands in.
    const double floor = 1e-2 * std::max(std::abs(here.value), 1.0);
    const double motion_size = std::max(here.stationarity.cwiseProduct(units).norm(), floor);
    const double design_size = std::max(here.partial_s.cwiseProduct(scale_).norm(), floor);
    for (int k = 0; k < kDirections; ++k) {
      const VectorXd v = random_direction(units, random);
      evaluate(s, m - kStep * v, Order::gradient, low);
      evaluate(s, m + kStep * v, Order::gradient, high);
      worst(check.motion, here.stationarity.dot(v), (high.value - low.value) / (2 * kStep),
            motion_size);
      const VectorXd change = (high.stationarity - low.stationarity) / (2 * kStep);
      const VectorXd exact = here.hessian_mm.selfadjointView<Eigen::Lower>() * v;
      worst(check.hessian_mm, (exact - change).cwiseProduct(units).norm(),
            exact.cwiseProduct(units).norm());
      if (s.size() == 0) continue;
      const VectorXd u = random_direction(scale_, random);
      evaluate(s - kStep * u, m, Order::gradient, low);
      evaluate(s + kStep * u, m, Order::gradient, high);
      worst(check.design, here.partial_s.dot(u), (high.value - low.value) / (2 * kStep),
            design_size);
      const VectorXd mixed = (high.stationarity - low.stationarity) / (2 * kStep);
      const VectorXd exact_ms = here.hessian_ms * u;
      worst(check.hessian_ms, (exact_ms - mixed).cwiseProduct(units).norm(),
            exact_ms.cwiseProduct(units).norm());
    }
  }

 private:
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) {
    objective_.evaluate(s, m, order, *workspace_, out);
  }
  static void worst(double& error, double difference, double size) {
    const double relative = difference / std::max(size, 1e-12);
    if (!(relative <= error)) error = relative;  // a NaN is the worst there is
  }
  static void worst(double& error, double exact, double difference, double size) {
    worst(error, std::abs(exact - difference), size);
  }

  const Objective& objective_;
  const VectorXd& scale_;
  std::unique_ptr<Objective::Workspace> workspace_;
};

/// F of a task, and its outer objective where there is one; the worse of the two counts.
void check_all(const CodesignProblem& problem, int task, const VectorXd& s, const VectorXd& m,
               GradientCheck& check) {
  const VectorXd scale = problem.robot.space.scale();
  Checker(*problem.objectives[task], scale).at(s, m, check);
  if (problem.outers.empty()) return;
  if (const auto* term = dynamic_cast<const OuterTerm*>(problem.outers[task].get()))
    Checker(term->quantity(), scale).at(s, m, check);
}

GradientCheck solved_check(const CodesignProblem& problem, const JointTask& task, int k) {
  const DesignSpace& space = problem.robot.space;
  const WeightedCost cost = weighted(task, 1.0, task.guess(space.initial()));
  CodesignOptions options;
  options.motion_only = true;
  const CodesignResult solved = codesign({cost}, space, space.initial(), options);
  GradientCheck check{task.name, "solved", 0, 0, 0, 0, -1.0};
  check_all(problem, k, solved.best.s, solved.best.tasks[0].m, check);
  const Certificate proof = certify({cost}, space, solved.best);
  const bool rests = solved.best.motion_status() == SolveStatus::converged;
  if (rests && proof.tasks[0].minimum_in_motion && proof.tasks[0].resolved)
    check.adjoint = proof.worst_gradient_error();
  return check;
}

}  // namespace

std::vector<GradientCheck> check_gradients(const CodesignProblem& problem) {
  const ProblemCosts costs(problem);
  const VectorXd s = problem.robot.space.initial();
  std::vector<GradientCheck> checks;
  for (int k = 0; k < problem.task_count(); ++k) {
    const JointTask& task = costs.tasks()[k];
    GradientCheck standing{task.name, "standing", 0, 0, 0, 0, -1.0};
    check_all(problem, k, s, task.guess(s), standing);
    checks.push_back(standing);
    checks.push_back(solved_check(problem, task, k));
  }
  return checks;
}

bool passes(const GradientCheck& check) {
  for (const double error : {check.motion, check.design, check.hessian_mm, check.hessian_ms})
    if (!(error < kGradientTolerance)) return false;
  return check.adjoint < kGradientTolerance;  // -1: nothing to compare
}

std::string to_text(const std::vector<GradientCheck>& checks) {
  std::string text =
      "derivatives against central differences: largest relative error in random directions\n";
  text += fmt::format("  {:14} {:10} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "task", "motion", "dF/dm",
                      "dF/ds|m", "d2F/dm2", "d2F/dmds", "adjoint");
  for (const GradientCheck& check : checks)
    text += fmt::format("  {:14} {:10} {:9.1e} {:9.1e} {:9.1e} {:9.1e} {:>9}  {}\n", check.task,
                        check.point, check.motion, check.design, check.hessian_mm, check.hessian_ms,
                        check.adjoint < 0.0 ? "-" : fmt::format("{:.1e}", check.adjoint),
                        passes(check) ? "ok" : "WRONG");
  return text +
         "  standing: the initial guess; solved: the motion of the initial design. adjoint: dF/ds\n"
         "  with all motions solved anew; - where the motion is no minimum to solve from\n";
}

Json to_json(const std::vector<GradientCheck>& checks) {
  Json rows = Json::array();
  for (const GradientCheck& check : checks)
    rows.push_back({{"task", check.task},
                    {"motion", check.point},
                    {"partial_m", check.motion},
                    {"partial_s", check.design},
                    {"hessian_mm", check.hessian_mm},
                    {"hessian_ms", check.hessian_ms},
                    {"adjoint", check.adjoint < 0.0 ? Json() : Json(check.adjoint)},
                    {"pass", passes(check)}});
  return rows;
}

}  // namespace legwright
