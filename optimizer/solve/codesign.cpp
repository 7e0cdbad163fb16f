// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/codesign.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "optimizer/solve/adjoint.hpp"
#include "optimizer/solve/lbfgs.hpp"
#include "optimizer/solve/predictor.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Codesign {
 public:
  Codesign(CostFunction& cost, const DesignSpace& space, const CodesignOptions& options)
      : cost_(cost),
        options_(options),
        scale_(space.scale()),
        lower_(space.lower()),
        upper_(space.upper()),
        lbfgs_(scale_, options.history) {
    now_.s = space.initial();
  }

  CodesignResult run(const VectorXd& initial_motion);

 private:
  SolveStatus optimise();
  SolveReport solve_motion(const VectorXd& s, VectorXd& m, double tolerance, int limit,
                           double ceiling);
  bool optimise_initial_motion();
  bool differentiate();
  void keep_factor(const SolveReport& report);
  bool step();
  bool search_along(const VectorXd& direction);
  double first_step(const VectorXd& direction, bool steepest) const;
  VectorXd start_of_trial(const VectorXd& s);
  void list_terms();
  bool publish(const Stopwatch& watch);
  bool value_settled() const;
  bool at_minimum() const;
  void polish();

  CostFunction& cost_;
  const CodesignOptions& options_;
  const VectorXd scale_, lower_, upper_;
  Lbfgs lbfgs_;
  NewtonWorkspace workspace_;
  HessianFactor factor_;  // of ∂G/∂m at the accepted (s, m)
  bool factor_exact_ = false;
  double last_shift_ = 0.0;
  Evaluation at_, probe_;  // at_: everything at the accepted (s, m), Order::design
  DesignIteration now_;
  std::vector<double> history_;
  CodesignResult result_;
};

CodesignResult Codesign::run(const VectorXd& initial_motion) {
  const Stopwatch watch;
  now_.m = initial_motion;
  result_.status = optimise();
  result_.best = now_;
  result_.seconds.total = watch.seconds();
  return std::move(result_);
}

SolveStatus Codesign::optimise() {
  {
    const Stopwatch watch;
    if (!optimise_initial_motion() || !differentiate()) {
      result_.initial = now_;
      return SolveStatus::not_finite;
    }
    const bool go_on = publish(watch);
    result_.initial = now_;
    if (!go_on) return SolveStatus::stopped;
    if (options_.motion_only) return now_.motion_status;
  }
  SolveStatus status = SolveStatus::iteration_limit;
  while (result_.design_iterations < options_.max_iterations) {
    if (now_.projected_gradient_norm < options_.design_tolerance) {
      status = at_minimum() ? SolveStatus::converged : SolveStatus::stalled;
      break;
    }
    const Stopwatch watch;
    if (value_settled() || !step()) {
      status = SolveStatus::stalled;
      break;
    }
    ++result_.design_iterations;
    now_.index = result_.design_iterations;
    if (!publish(watch)) return SolveStatus::stopped;
  }
  polish();
  return status == SolveStatus::converged && !at_minimum() ? SolveStatus::stalled : status;
}

// Only the adjoint at a minimum in m tells that dF/ds vanishes: the gradient at fixed m does not.
bool Codesign::at_minimum() const {
  return now_.exact_gradient && now_.motion_status == SolveStatus::converged &&
         now_.projected_gradient_norm < options_.design_tolerance;
}

SolveReport Codesign::solve_motion(const VectorXd& s, VectorXd& m, double tolerance, int limit,
                                   double ceiling) {
  const Stopwatch watch;
  NewtonOptions newton_options = options_.newton;
  newton_options.tolerance = tolerance;
  newton_options.max_iterations = limit;
  newton_options.value_ceiling = ceiling;
  newton_options.stagnation_window = options_.stagnation_window;
  newton_options.stagnation_decrease = options_.stagnation_decrease;
  const SolveReport report = newton(cost_, s, m, newton_options, workspace_);
  result_.newton_iterations += report.iterations;
  result_.factorisations += report.factorisations;
  result_.evaluations += report.evaluations;
  now_.newton_iterations += report.iterations;
  result_.seconds.motion += watch.seconds();
  return report;
}

// Iteration 0. A robot that cannot do the task has no good motion to converge to; hundreds of steps
// towards it would be thrown away with the design, so it is left when F hardly falls any more.
bool Codesign::optimise_initial_motion() {
  const SolveReport report =
      solve_motion(now_.s, now_.m, options_.final_tolerance, options_.motion_iterations,
                   std::numeric_limits<double>::infinity());
  now_.value = report.value;
  now_.motion_status = report.status;
  result_.motion_only_trace = report.history;
  if (report.status == SolveStatus::not_finite) return false;
  keep_factor(report);
  return true;
}

// Newton's last factor becomes the one of the accepted iterate.
void Codesign::keep_factor(const SolveReport& report) {
  std::swap(factor_, workspace_.factor);
  factor_exact_ = report.exact_factor;
  last_shift_ = report.shift;
}

// dF/ds at the accepted (s, m), eqs (7), (8) with J = F. Without a minimum in m there is no
// adjoint: then the gradient at fixed m, ∂F/∂s, still leads down, and a shifted factor still
// predicts.
bool Codesign::differentiate() {
  const Stopwatch watch;
  cost_.evaluate(now_.s, now_.m, Order::design, at_);
  ++result_.evaluations;
  if (!std::isfinite(at_.value) || !at_.partial_s.allFinite() || !at_.hessian_ms.allFinite())
    return false;
  if (!factor_exact_) {
    ++result_.factorisations;
    factor_exact_ = factor_.factor(at_.hessian_mm, {});
  }
  AdjointResult result;
  if (factor_exact_) result = adjoint(factor_, at_.stationarity, at_.hessian_ms, at_.partial_s);
  now_.exact_gradient = result.status == SolveStatus::converged;
  now_.adjoint_residual = now_.exact_gradient ? result.residual : 0.0;
  now_.design_gradient = now_.exact_gradient ? result.dJ_ds : at_.partial_s;
  if (!factor_exact_ && last_shift_ > 0.0) {
    const VectorXd shift = last_shift_ * cost_.motion_units().cwiseAbs2().cwiseInverse();
    ++result_.factorisations;
    (void)factor_.factor(at_.hessian_mm, shift);  // predict() asks the factor itself
  }
  now_.projected_gradient_norm =
      projected_gradient_norm(now_.s, now_.design_gradient, lower_, upper_, scale_);
  result_.seconds.adjoint += watch.seconds();
  return true;
}

// update(Δs) of Algorithm 1. When no δ₁ helps, the pairs are dropped for one try along steepest
// descent.
bool Codesign::step() {
  const DesignIteration before = now_;
  const VectorXd& gradient = before.design_gradient;
  const std::vector<bool> free = free_parameters(before.s, gradient, lower_, upper_);
  now_.newton_iterations = 0;
  bool moved = search_along(lbfgs_.direction(gradient, free));
  if (!moved && lbfgs_.pair_count() > 0) {
    lbfgs_.reset();
    moved = search_along(lbfgs_.direction(gradient, free));
  }
  if (!moved || !differentiate()) {
    now_ = before;
    return false;
  }
  // A pair must not mix the adjoint gradient with the one at fixed m.
  const bool same_kind = now_.exact_gradient == before.exact_gradient;
  if (!same_kind || !lbfgs_.add(now_.s - before.s, now_.design_gradient - gradient)) lbfgs_.reset();
  return true;
}

double Codesign::first_step(const VectorXd& direction, bool steepest) const {
  const double change = direction.cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
  if (!(change > 0.0)) return 0.0;
  return steepest ? options_.largest_first_change / change
                  : std::min(1.0, options_.largest_change / change);
}

bool Codesign::search_along(const VectorXd& direction) {
  double design_step = first_step(direction, lbfgs_.pair_count() == 0);
  if (!(design_step > 0.0)) return false;
  for (int k = 0; k < options_.line_search_steps; ++k, design_step *= 0.5) {
    const VectorXd s = (now_.s + design_step * direction).cwiseMax(lower_).cwiseMin(upper_);
    const double promised =
        -now_.design_gradient.dot(s - now_.s);  // along the path bent by the bounds
    if (!(promised > 0.0)) continue;
    const double ceiling = now_.value - options_.sufficient_decrease * promised;
    VectorXd m = start_of_trial(s);
    const SolveReport report =
        solve_motion(s, m, options_.motion_tolerance, options_.trial_iterations, ceiling);
    if (report.status == SolveStatus::not_finite || !(report.value <= ceiling)) {
      ++result_.rejected_trials;
      continue;
    }
    now_.s = s;
    now_.m = std::move(m);
    now_.value = report.value;
    now_.motion_status = report.status;
    now_.design_step = design_step;
    keep_factor(report);
    return true;
  }
  return false;
}

// The motion predicted for the new design, or the old one where that is no better.
VectorXd Codesign::start_of_trial(const VectorXd& s) {
  const Stopwatch watch;
  VectorXd ahead;
  VectorXd start = now_.m;
  if (predict(factor_, now_.m, at_.stationarity, at_.hessian_ms, s - now_.s, ahead)) {
    cost_.evaluate(s, now_.m, Order::value, probe_);
    const double stay = probe_.value;
    cost_.evaluate(s, ahead, Order::value, probe_);
    result_.evaluations += 2;
    if (std::isfinite(probe_.value) && !(probe_.value >= stay)) start = std::move(ahead);
  }
  result_.seconds.predictor += watch.seconds();
  return start;
}

bool Codesign::value_settled() const {
  if (history_.size() < 4) return false;
  const double before = history_[history_.size() - 4], after = history_.back();
  return before - after < options_.value_tolerance * std::max(std::abs(before), 1e-12);
}

void Codesign::list_terms() {
  now_.terms.clear();
  const std::vector<std::string_view> names = cost_.term_names();
  for (std::size_t k = 0; k < names.size() && k < at_.term_values.size(); ++k)
    now_.terms.push_back({names[k], at_.term_values[k]});
}

// Completes now_ and hands it to the caller; false: stop.
bool Codesign::publish(const Stopwatch& watch) {
  history_.push_back(now_.value);
  list_terms();
  now_.seconds = watch.seconds();
  return !options_.on_iteration || options_.on_iteration(now_);
}

// The result's motion to the final tolerance, at the design that was found.
void Codesign::polish() {
  if (result_.design_iterations == 0) return;  // iteration 0 was solved to it already
  const Stopwatch watch;
  VectorXd m = now_.m;
  const SolveReport report =
      solve_motion(now_.s, m, options_.final_tolerance, options_.motion_iterations,
                   std::numeric_limits<double>::infinity());
  if (report.status == SolveStatus::not_finite ||
      report.value > now_.value + 1e-12 * std::abs(now_.value))
    return;
  now_.m = std::move(m);
  now_.value = report.value;
  now_.motion_status = report.status;
  keep_factor(report);
  differentiate();
  list_terms();
  now_.seconds += watch.seconds();
}

}  // namespace

CodesignResult codesign(CostFunction& cost, const DesignSpace& space,
                        const VectorXd& initial_motion, const CodesignOptions& options) {
  return Codesign(cost, space, options).run(initial_motion);
}

CodesignResult codesign(const Objective& objective, const DesignSpace& space,
                        const CodesignOptions& options) {
  ObjectiveCost cost(objective);
  return codesign(cost, space, initial_guess(objective, space.initial()), options);
}

}  // namespace legwright
