// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/task_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "optimizer/base/stopwatch.hpp"
#include "optimizer/solve/adjoint.hpp"
#include "optimizer/solve/predictor.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kEarlySteps = 10;  // of iteration 0
constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

TaskSolver::TaskSolver(const WeightedCost& task, const MotionLimits& limits, Checkpoint checkpoint)
    : task_(task), limits_(limits), checkpoint_(std::move(checkpoint)) {
  here_.m = task.initial_motion;
}

void TaskSolver::take(const SolveReport& report, Point& point) const {
  point.value = report.value;
  point.status = report.status;
  point.factor_exact = report.exact_factor;
  point.shift = report.shift;
}

void TaskSolver::show_here() {
  now_.m = here_.m;
  now_.value = here_.value;
  now_.outer_value = here_.outer_value;
  now_.motion_status = here_.status;
}

NewtonOptions TaskSolver::options(double tolerance, int limit) const {
  NewtonOptions options = limits_.newton;
  options.tolerance = tolerance;
  options.max_iterations = limit;
  options.stagnation_window = limits_.stagnation_window;
  options.stagnation_decrease = limits_.stagnation_decrease;
  return options;
}

SolveReport TaskSolver::solve(const VectorXd& s, VectorXd& m, NewtonOptions options) {
  const Stopwatch watch;
  options.checkpoint = checkpoint_.in(solves_++);
  SolveReport report = newton(*task_.cost, s, m, options, workspace_);
  effort_.newton_iterations += report.iterations;
  effort_.factorisations += report.factorisations;
  effort_.evaluations += report.evaluations;
  now_.newton_iterations += report.iterations;
  effort_.solve_seconds.push_back(watch.seconds());
  effort_.motion_seconds += watch.seconds();
  return report;
}

double TaskSolver::outer_value(const VectorXd& s, const VectorXd& m) {
  if (!task_.outer) return 0.0;
  task_.outer->evaluate(s, m, Order::value, probe_);
  ++effort_.evaluations;
  return probe_.value;
}

// A robot that cannot do the task has no good motion to converge to; hundreds of steps towards it
// would be thrown away with the design, so the solve is left when F hardly falls any more.
bool TaskSolver::start(const VectorXd& s) {
  here_.s = s;
  NewtonOptions rules = options(limits_.final_tolerance, limits_.motion_iterations);
  Checkpoint early = checkpoint_.in("early");
  const auto pass_early = [this](SolveState& state) { state(early_motion_); };
  (void)early.take_up(pass_early);
  rules.on_step = [&](int steps, const VectorXd& m) {
    if (steps != kEarlySteps) return;
    early_motion_ = m;
    early.keep(pass_early);
  };
  const SolveReport report = solve(s, here_.m, rules);
  motion_only_trace_ = report.history;
  take(report, here_);
  std::swap(factor_, workspace_.factor);
  here_.outer_value = outer_value(s, here_.m);
  show_here();
  return report.status != SolveStatus::not_finite && std::isfinite(here_.outer_value);
}

double TaskSolver::try_design(const VectorXd& s, double ceiling) {
  trial_.s = s;
  trial_.m = predicted_motion(s);
  // F hardly feels a motion that is not quite at its minimum, J does to first order.
  NewtonOptions rules = options(outer_counts_ ? limits_.final_tolerance : limits_.motion_tolerance,
                                limits_.trial_iterations);
  rules.value_ceiling = ceiling;
  const SolveReport report = solve(s, trial_.m, rules);
  take(report, trial_);
  if (report.status == SolveStatus::not_finite) return kInfinite;
  trial_.outer_value = outer_value(s, trial_.m);
  const double total = trial_.value + (outer_counts_ ? trial_.outer_value : 0.0);
  if (!std::isfinite(total)) return kInfinite;
  return total;
}

// Newton's last factor becomes the one of the iterate.
void TaskSolver::accept() {
  std::swap(here_, trial_);
  std::swap(factor_, workspace_.factor);
  show_here();
}

bool TaskSolver::differentiate() {
  const Stopwatch watch;
  task_.cost->evaluate(here_.s, here_.m, Order::design, at_);
  ++effort_.evaluations;
  VectorXd dJ_dm = at_.stationarity, partial_s = at_.partial_s;
  if (outer_counts_) {
    task_.outer->evaluate(here_.s, here_.m, Order::gradients, outer_at_);
    ++effort_.evaluations;
    dJ_dm += outer_at_.stationarity;
    partial_s += outer_at_.partial_s;
  }
  now_.sensitivity.resize(0, 0);
  now_.terms = named_terms(*task_.cost, at_);
  now_.stationarity =
      at_.stationarity.cwiseProduct(task_.cost->motion_units()).lpNorm<Eigen::Infinity>();
  if (!std::isfinite(at_.value) || !partial_s.allFinite() || !at_.hessian_ms.allFinite())
    return false;
  if (!here_.factor_exact) {
    ++effort_.factorisations;
    here_.factor_exact = factor_.factor(at_.hessian_mm, {});
  }
  AdjointResult result;
  if (here_.factor_exact) result = adjoint(factor_, dJ_dm, at_.hessian_ms, partial_s);
  now_.exact_gradient = result.status == SolveStatus::converged;
  now_.adjoint_residual = now_.exact_gradient ? result.residual : 0.0;
  now_.design_gradient = now_.exact_gradient ? result.dJ_ds : partial_s;
  if (!here_.factor_exact) restore_shifted_factor();
  effort_.adjoint_seconds += watch.seconds();
  return now_.design_gradient.allFinite();
}

// A shifted factor still predicts.
void TaskSolver::restore_shifted_factor() {
  if (!(here_.shift > 0.0)) return;
  const VectorXd shift = here_.shift * task_.cost->motion_units().cwiseAbs2().cwiseInverse();
  ++effort_.factorisations;
  (void)factor_.factor(at_.hessian_mm, shift);  // predict() asks the factor itself
}

bool TaskSolver::reduced_hessian(Eigen::MatrixXd& hessian) {
  if (!here_.factor_exact || !factor_.positive()) return false;
  const Stopwatch watch;
  Eigen::MatrixXd& dm_ds = now_.sensitivity;
  if (!factor_.solve(at_.hessian_ms, dm_ds)) {
    dm_ds.resize(0, 0);
    return false;
  }
  dm_ds = -dm_ds;
  hessian = at_.hessian_ss + at_.hessian_ms.transpose() * dm_ds;
  hessian = 0.5 * (hessian + hessian.transpose()).eval();
  effort_.adjoint_seconds += watch.seconds();
  return hessian.allFinite();
}

VectorXd TaskSolver::predicted_motion(const VectorXd& s) {
  const Stopwatch watch;
  VectorXd ahead;
  VectorXd start = here_.m;
  if (predict(factor_, here_.m, at_.stationarity, at_.hessian_ms, s - here_.s, ahead)) {
    task_.cost->evaluate(s, here_.m, Order::value, probe_);
    const double stay = probe_.value;
    const PredictedValue there = bend_prediction(*task_.cost, here_.s, here_.m, s, ahead, probe_);
    effort_.evaluations += 1 + there.evaluations;
    if (std::isfinite(there.value) && !(there.value >= stay)) start = std::move(ahead);
  }
  effort_.predictor_seconds += watch.seconds();
  return start;
}

bool TaskSolver::adopt(const VectorXd& s, const VectorXd& m) {
  task_.cost->evaluate(s, m, Order::value, probe_);
  ++effort_.evaluations;
  here_ = {s, m};
  here_.value = probe_.value;
  here_.outer_value = outer_value(s, m);
  show_here();
  return std::isfinite(here_.value) && std::isfinite(here_.outer_value);
}

void TaskSolver::polish() {
  trial_.s = here_.s;
  trial_.m = here_.m;
  const SolveReport report =
      solve(trial_.s, trial_.m, options(limits_.final_tolerance, limits_.motion_iterations));
  take(report, trial_);
  if (report.status == SolveStatus::not_finite ||
      report.value > here_.value + 1e-12 * std::abs(here_.value))
    return;
  trial_.outer_value = outer_value(trial_.s, trial_.m);
  accept();
}

std::vector<double> ceilings(const TaskSolvers& solvers, double total, double largest_gain) {
  std::vector<double> values;
  double others = 0.0;
  for (const auto& solver : solvers) {
    const double value = solver->weight() * solver->searched_value();
    values.push_back(value - largest_gain * std::abs(value));
    others += values.back();
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    const double alone = solvers.size() == 1 ? 0.0 : others - values[i];
    result.push_back(solvers[i]->outer_counts() ? kInfinite
                                                : (total - alone) / solvers[i]->weight());
  }
  return result;
}

}  // namespace legwright
