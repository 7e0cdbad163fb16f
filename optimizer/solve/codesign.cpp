// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/codesign.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "optimizer/base/parallel.hpp"
#include "optimizer/base/stopwatch.hpp"
#include "optimizer/solve/joint_search.hpp"
#include "optimizer/solve/lbfgs.hpp"
#include "optimizer/solve/reduced_step.hpp"
#include "optimizer/solve/trust_region.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr double kLeastDesignStep = 1e-6;  // trusted after a poor step

class Codesign {
 public:
  Codesign(const std::vector<WeightedCost>& tasks, const DesignSpace& space, const VectorXd& start,
           const CodesignOptions& options)
      : options_(options),
        box_{space.lower(), space.upper(), space.scale()},
        lbfgs_(box_.scale, options.history),
        trust_{options.largest_first_change, options.largest_change, kLeastDesignStep} {
    for (const WeightedCost& task : tasks) {
      const int k = static_cast<int>(solvers_.size());
      solvers_.push_back(std::make_unique<TaskSolver>(task, options, options.checkpoint.in(k)));
    }
    now_.s = start;
  }

  CodesignResult run();

 private:
  SolveStatus optimise();
  SolveStatus search(int iterations);
  bool search_jointly(int iterations);
  bool follow(const JointPoint& point, bool last);
  bool has_outer() const;
  bool minimise_outer();
  void for_each_task(const std::function<void(int)>& work) const;
  bool differentiate();
  void show_tasks();
  bool step();
  VectorXd newton_direction() const;
  VectorXd lbfgs_direction() const;
  bool search_along(const VectorXd& direction);
  double first_step(const VectorXd& direction) const;
  double try_design(const VectorXd& s, double ceiling);
  bool publish(const Stopwatch& watch);
  bool value_settled() const;
  bool at_minimum() const;
  void polish();
  void add_up();

  const CodesignOptions& options_;
  const DesignBox box_;
  Lbfgs lbfgs_;
  TrustRegion trust_;
  bool newton_ = false;  // the direction at hand is Newton's
  TaskSolvers solvers_;
  DesignIteration now_;
  double searched_ = 0.0;        // Σ wᵢ Fᵢ, and Jᵢ where it counts: what the search lowers
  std::vector<double> history_;  // of it
  CodesignResult result_;
};

CodesignResult Codesign::run() {
  const Stopwatch watch;
  result_.status = optimise();
  result_.best = now_;
  add_up();
  result_.seconds.total = watch.seconds();
  return std::move(result_);
}

void Codesign::for_each_task(const std::function<void(int)>& work) const {
  parallel_for(static_cast<int>(solvers_.size()), options_.threads, work);
}

SolveStatus Codesign::optimise() {
  {
    const Stopwatch watch;
    std::vector<int> finite(solvers_.size());
    for_each_task([&](int i) { finite[i] = solvers_[i]->start(now_.s); });
    if (options_.near_optimum)
      for (const auto& solver : solvers_) solver->minimise_outer();
    for (const auto& solver : solvers_)
      result_.motion_only_traces.push_back(solver->motion_only_trace());
    show_tasks();
    const bool usable = std::all_of(finite.begin(), finite.end(), [](int c) { return c != 0; });
    if (!usable || !differentiate()) {
      result_.initial = now_;
      return SolveStatus::not_finite;
    }
    const bool go_on = publish(watch);
    result_.initial = now_;
    if (!go_on) return SolveStatus::stopped;
    if (options_.motion_only || now_.s.size() == 0) return now_.motion_status();
  }
  const int limit = options_.max_iterations;
  const bool alone = has_outer() && !options_.near_optimum;  // first F
  const int first = alone ? (limit + 1) / 2 : limit;
  if (!search_jointly(first)) return SolveStatus::stopped;
  SolveStatus status = search(first);
  if (status != SolveStatus::stopped && alone && minimise_outer()) status = search(limit);
  if (status == SolveStatus::stopped) return status;
  polish();
  return status == SolveStatus::converged && !at_minimum() ? SolveStatus::stalled : status;
}

// Body and motions together, from the first motions and from those on the way of iteration 0.
// @return false where the caller asked to stop
bool Codesign::search_jointly(int iterations) {
  const bool wanted = options_.method == DesignMethod::joint && !options_.near_optimum;
  if (!wanted || iterations <= 0) return true;
  const Stopwatch whole;
  const JointNewtonResult found = joint_search(solvers_, box_, now_.s, options_);
  result_.newton_iterations += found.iterations * static_cast<int>(solvers_.size());
  result_.factorisations += found.factorisations;
  result_.evaluations += found.evaluations;
  result_.seconds.motion += whole.seconds();
  const bool stopped = found.status == SolveStatus::stopped;
  // Its first points may have more F than iteration 0, whose motion is the best for its design.
  const std::vector<JointPoint> points =
      last_points(found, searched_, now_.s, stopped ? 1 : iterations);
  for (const JointPoint& point : points) {
    const Stopwatch watch;
    for (const auto& solver : solvers_) solver->begin_iteration();
    if (!follow(point, &point == &points.back())) break;
    now_.index = ++result_.design_iterations;
    if (!publish(watch)) return false;
  }
  if (!points.empty()) history_.clear();
  return !stopped;
}

// Makes a point of a joint search the iterate; the last one with its motions at their minimum.
bool Codesign::follow(const JointPoint& point, bool last) {
  const DesignIteration before = now_;
  std::vector<int> finite(solvers_.size());
  for_each_task([&](int i) {
    finite[i] = solvers_[i]->adopt(point.s, point.motions[i]);
    if (finite[i] && last) solvers_[i]->polish();
  });
  now_.s = point.s;
  if (std::all_of(finite.begin(), finite.end(), [](int c) { return c != 0; }) && differentiate())
    return true;
  for_each_task([&](int i) {
    (void)solvers_[i]->adopt(before.s, before.tasks[static_cast<std::size_t>(i)].m);
    (void)solvers_[i]->differentiate();
  });
  now_ = before;
  return false;
}

bool Codesign::has_outer() const {
  return std::any_of(solvers_.begin(), solvers_.end(),
                     [](const auto& s) { return s->has_outer(); });
}

// The design's F has a Hessian, F + J has none, and from a body that cannot do the task J leads
// astray: so the search for F + J sets out from the optimum of F.
bool Codesign::minimise_outer() {
  for (const auto& solver : solvers_) solver->minimise_outer();
  lbfgs_.reset();
  history_.clear();
  return differentiate();
}

// @param iterations that the run may have made at the end
SolveStatus Codesign::search(int iterations) {
  SolveStatus status = SolveStatus::iteration_limit;
  while (result_.design_iterations < iterations) {
    if (now_.projected_gradient_norm < options_.design_tolerance) {
      status = at_minimum() ? SolveStatus::converged : SolveStatus::stalled;
      break;
    }
    if (options_.go_on && !options_.go_on()) return SolveStatus::stopped;
    const Stopwatch watch;
    if (value_settled() || !step()) {
      status = SolveStatus::stalled;
      break;
    }
    ++result_.design_iterations;
    now_.index = result_.design_iterations;
    if (!publish(watch)) return SolveStatus::stopped;
  }
  return status;
}

// Only the adjoint at a minimum in m shows that dF/ds vanishes: the gradient at fixed m does not.
bool Codesign::at_minimum() const {
  return now_.exact_gradient && now_.motion_status() == SolveStatus::converged &&
         now_.projected_gradient_norm < options_.design_tolerance;
}

// Copies what the solvers know into now_, and sums it up.
void Codesign::show_tasks() {
  now_.tasks.clear();
  now_.value = searched_ = 0.0;
  now_.newton_iterations = 0;
  now_.exact_gradient = true;
  now_.design_gradient.setZero(now_.s.size());
  for (const auto& solver : solvers_) {
    const TaskIterate& task = solver->now();
    now_.value += solver->weight() * (task.value + task.outer_value);
    searched_ += solver->weight() * solver->searched_value();
    now_.newton_iterations += task.newton_iterations;
    now_.exact_gradient = now_.exact_gradient && task.exact_gradient;
    if (task.design_gradient.size() == now_.s.size())
      now_.design_gradient += solver->weight() * task.design_gradient;
    now_.tasks.push_back(task);
  }
}

bool Codesign::differentiate() {
  const int count = static_cast<int>(solvers_.size());
  const bool outer = std::any_of(solvers_.begin(), solvers_.end(),
                                 [](const auto& s) { return s->outer_counts(); });
  const bool second = options_.method != DesignMethod::lbfgs && !outer && !options_.motion_only;
  std::vector<int> finite(count), curved(count);
  std::vector<Eigen::MatrixXd> hessians(count);
  for_each_task([&](int i) {
    finite[i] = solvers_[i]->differentiate();
    curved[i] = finite[i] && second && solvers_[i]->reduced_hessian(hessians[i]);
  });
  if (!std::all_of(finite.begin(), finite.end(), [](int c) { return c != 0; })) return false;
  show_tasks();
  now_.reduced_hessian.resize(0, 0);
  if (std::all_of(curved.begin(), curved.end(), [](int c) { return c != 0; })) {
    now_.reduced_hessian.setZero(now_.s.size(), now_.s.size());
    for (int i = 0; i < count; ++i) now_.reduced_hessian += solvers_[i]->weight() * hessians[i];
  }
  now_.projected_gradient_norm =
      projected_gradient_norm(now_.s, now_.design_gradient, box_.lower, box_.upper, box_.scale);
  return true;
}

// update(Δs) of Algorithm 1. When no δ₁ helps along Newton's direction, L-BFGS has its turn; when
// that fails too, the pairs are dropped for one try along steepest descent.
bool Codesign::step() {
  const DesignIteration before = now_;
  for (const auto& solver : solvers_) solver->begin_iteration();
  newton_ = now_.reduced_hessian.size() > 0;
  bool moved = newton_ && search_along(newton_direction());
  if (!moved) {
    newton_ = false;
    moved = search_along(lbfgs_direction());
  }
  if (!moved && lbfgs_.pair_count() > 0) {
    lbfgs_.reset();
    moved = search_along(lbfgs_direction());
  }
  if (!moved) {
    now_ = before;
    return false;
  }
  if (!differentiate()) {
    for_each_task([&](int i) {
      solvers_[i]->undo();
      solvers_[i]->differentiate();
    });
    now_ = before;
    return false;
  }
  // A pair must not mix the adjoint gradient with the one at fixed m.
  const bool same_kind = now_.exact_gradient == before.exact_gradient;
  if (!same_kind || !lbfgs_.add(now_.s - before.s, now_.design_gradient - before.design_gradient))
    lbfgs_.reset();
  return true;
}

VectorXd Codesign::newton_direction() const {
  return reduced_newton_step(now_.reduced_hessian, now_.design_gradient, now_.s, box_,
                             trust_.radius);
}

VectorXd Codesign::lbfgs_direction() const {
  return lbfgs_.direction(now_.design_gradient,
                          free_parameters(now_.s, now_.design_gradient, box_.lower, box_.upper));
}

double Codesign::first_step(const VectorXd& direction) const {
  const double change = direction.cwiseQuotient(box_.scale).lpNorm<Eigen::Infinity>();
  if (!(change > 0.0)) return 0.0;
  if (newton_) return 1.0;  // within the trust region by construction
  return lbfgs_.pair_count() == 0 ? options_.largest_first_change / change
                                  : std::min(1.0, options_.largest_change / change);
}

bool Codesign::search_along(const VectorXd& direction) {
  double design_step = first_step(direction);
  if (!(design_step > 0.0)) return false;
  for (int k = 0; k < options_.line_search_steps; ++k, design_step *= 0.5) {
    const VectorXd s = (now_.s + design_step * direction).cwiseMax(box_.lower).cwiseMin(box_.upper);
    const double slope =
        -now_.design_gradient.dot(s - now_.s);  // along the path bent by the bounds
    if (!(slope > 0.0)) continue;
    const double ceiling = searched_ - options_.sufficient_decrease * slope;
    const double value = try_design(s, ceiling);
    if (!(value <= ceiling)) {
      ++result_.rejected_trials;
      continue;
    }
    if (newton_) {
      const double promised = -model_change(now_.reduced_hessian, now_.design_gradient, s - now_.s);
      trust_.adapt((searched_ - value) / std::max(promised, 1e-300),
                   (s - now_.s).cwiseQuotient(box_.scale).lpNorm<Eigen::Infinity>());
    }
    for (const auto& solver : solvers_) solver->accept();
    now_.s = s;
    now_.design_step = design_step;
    return true;
  }
  return false;
}

double Codesign::try_design(const VectorXd& s, double ceiling) {
  const std::vector<double> limits = ceilings(solvers_, ceiling, options_.largest_task_gain);
  std::vector<double> values(solvers_.size());
  for_each_task([&](int i) { values[i] = solvers_[i]->try_design(s, limits[i]); });
  double total = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) total += solvers_[i]->weight() * values[i];
  return total;
}

bool Codesign::value_settled() const {
  if (history_.size() < 4) return false;
  const double before = history_[history_.size() - 4], after = history_.back();
  return before - after < options_.value_tolerance * std::max(std::abs(before), 1e-12);
}

// Completes now_ and hands it to the caller; false: stop.
bool Codesign::publish(const Stopwatch& watch) {
  history_.push_back(searched_);
  now_.seconds = watch.seconds();
  return !options_.on_iteration || options_.on_iteration(now_);
}

// The result's motions to the final tolerance, at the design that was found.
void Codesign::polish() {
  if (result_.design_iterations == 0) return;  // iteration 0 was solved to it already
  const Stopwatch watch;
  for_each_task([&](int i) { solvers_[i]->polish(); });
  differentiate();
  now_.seconds += watch.seconds();
}

void Codesign::add_up() {
  for (const auto& solver : solvers_) {
    const TaskEffort& effort = solver->effort();
    result_.newton_iterations += effort.newton_iterations;
    result_.factorisations += effort.factorisations;
    result_.evaluations += effort.evaluations;
    result_.seconds.motion += effort.motion_seconds;
    result_.seconds.adjoint += effort.adjoint_seconds;
    result_.seconds.predictor += effort.predictor_seconds;
    if (!effort.solve_seconds.empty())
      result_.solve_seconds.insert(result_.solve_seconds.end(), effort.solve_seconds.begin() + 1,
                                   effort.solve_seconds.end());
  }
}

}  // namespace

SolveStatus DesignIteration::motion_status() const {
  for (const TaskIterate& task : tasks)
    if (task.motion_status != SolveStatus::converged) return task.motion_status;
  return tasks.empty() ? SolveStatus::not_finite : SolveStatus::converged;
}

CodesignResult codesign(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                        const VectorXd& start, const CodesignOptions& options) {
  return Codesign(tasks, space, start, options).run();
}

CodesignResult codesign(const Objective& objective, const DesignSpace& space,
                        const CodesignOptions& options) {
  ObjectiveCost cost(objective);
  const VectorXd start = space.initial();
  WeightedCost task;
  task.cost = &cost;
  task.initial_motion = initial_guess(objective, start);
  return codesign({task}, space, start, options);
}

}  // namespace legwright
