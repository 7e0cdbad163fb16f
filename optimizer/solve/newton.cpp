// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "optimizer/solve/damping.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

// F is a sum of many parts: differences below this share of it are rounding.
constexpr double kValueNoise = 1e-13;

bool finite(const Evaluation& e) { return std::isfinite(e.value) && e.stationarity.allFinite(); }

bool finite_hessian(const Evaluation& e) {
  return Eigen::Map<const VectorXd>(e.hessian_mm.valuePtr(), e.hessian_mm.nonZeros()).allFinite();
}

/// All but its history.
void pass_report(SolveState& state, SolveReport& report) {
  state(report.status);
  state(report.iterations);
  state(report.factorisations);
  state(report.evaluations);
  state(report.value);
  state(report.stationarity);
  state(report.shift);
  state(report.shifted_steps);
  state(report.exact_factor);
  state(report.stagnated);
}

// Eigen's sparse matrices do not move: std::swap would copy half a megabyte three times.
void exchange(Evaluation& a, Evaluation& b) {
  Eigen::SparseMatrix<double> of_a, of_b;
  of_a.swap(a.hessian_mm);
  of_b.swap(b.hessian_mm);
  std::swap(a, b);
  a.hessian_mm.swap(of_b);
  b.hessian_mm.swap(of_a);
}

class Newton {
 public:
  Newton(CostFunction& cost, const VectorXd& s, VectorXd& m, const NewtonOptions& options,
         NewtonWorkspace& w)
      : cost_(cost),
        s_(s),
        m_(m),
        options_(options),
        w_(w),
        units_(cost.motion_units()),
        damping_(options),
        checkpoint_(options.checkpoint && options.go_on && !options.go_on() ? Checkpoint()
                                                                            : options.checkpoint),
        origin_(s.squaredNorm() + m.squaredNorm()) {}

  SolveReport run();

 private:
  enum class Outcome { moved, no_direction, no_decrease };

  void evaluate(const VectorXd& m, Order order, Evaluation& out) {
    cost_.evaluate(s_, m, order, out);
    ++report_.evaluations;
  }
  double norm(const VectorXd& g) const { return g.cwiseProduct(units_).lpNorm<Eigen::Infinity>(); }
  double noise() const { return kValueNoise * std::max(1.0, std::abs(w_.here.value)); }

  void pass_state(SolveState& state);
  bool take_up();
  void keep_state();
  bool factor();
  Outcome iterate();
  bool search();
  double trial_value(double t);
  bool settle_within_noise();
  bool take();
  void relax();
  bool stagnated() const;
  bool beyond_ceiling() const;
  SolveReport certify();
  SolveReport finish(SolveStatus status);

  CostFunction& cost_;
  const VectorXd& s_;
  VectorXd& m_;
  const NewtonOptions& options_;
  NewtonWorkspace& w_;
  const VectorXd& units_;
  SolveReport report_;
  Damping damping_;
  double factored_shift_ = -1.0;  // σ in the factor at hand for `here`; −1: another matrix
  double slope_ = 0.0;            // Gᵀp
  double step_length_ = 0.0;      // t of the step taken
  bool full_step_ = false;
  double agreement_ = 0.0;       // actual / promised decrease
  std::vector<double> history_;  // F by iteration
  // What a solve does that begins once a run was asked to stop is not what it does in a whole run.
  Checkpoint checkpoint_;
  double origin_;  // tells (s, first m): a state is of no use to a solve from elsewhere
  bool finished_ = false;
};

// All that the next iteration depends on, or what a finished solve returns.
void Newton::pass_state(SolveState& state) {
  state(m_);
  state(history_);
  state(factored_shift_);
  state(finished_);
  damping_.pass_state(state);
  pass_report(state, report_);
}

// Where a process before this one had come to something. @return whether it had
bool Newton::take_up() {
  if (!checkpoint_.take_up([this](SolveState& state) { pass_state(state); }, origin_)) return false;
  cost_.evaluate(s_, m_, Order::hessian, w_.here);
  if (!finished_) return true;
  report_.history = history_;
  if (factored_shift_ >= 0.0)  // callers solve with the last factor
    (void)w_.factor.factor(w_.here.hessian_mm, factored_shift_ * units_.cwiseAbs2().cwiseInverse());
  return true;
}

void Newton::keep_state() {
  checkpoint_.keep([this](SolveState& state) { pass_state(state); }, origin_);
}

SolveReport Newton::run() {
  if (!take_up()) {
    evaluate(m_, Order::hessian, w_.here);
    if (!finite(w_.here) || !finite_hessian(w_.here)) return finish(SolveStatus::not_finite);
    history_.push_back(w_.here.value);
  }
  if (finished_) return report_;
  for (;;) {
    if (checkpoint_.due()) keep_state();
    if (norm(w_.here.stationarity) < options_.tolerance) return certify();
    if (report_.iterations >= options_.max_iterations) return finish(SolveStatus::iteration_limit);
    if (stagnated()) {
      report_.stagnated = true;
      return finish(SolveStatus::iteration_limit);
    }
    if (beyond_ceiling()) return finish(SolveStatus::stopped);
    if (options_.go_on && !options_.go_on()) {
      keep_state();
      checkpoint_ = {};
      return finish(SolveStatus::stopped);
    }
    if (iterate() != Outcome::moved) return finish(SolveStatus::stalled);
    ++report_.iterations;
    history_.push_back(w_.here.value);
    if (options_.on_step) options_.on_step(report_.iterations, m_);
  }
}

bool Newton::factor() {
  w_.shift_diagonal = damping_.diagonal(units_);
  ++report_.factorisations;
  factored_shift_ = damping_.shift();
  return w_.factor.factor(w_.here.hessian_mm, w_.shift_diagonal);
}

// One accepted step. The Hessian stays, σ grows, until a factor is positive and its step can be
// kept.
Newton::Outcome Newton::iterate() {
  Outcome failure = Outcome::no_direction;
  for (int attempt = 0; attempt < options_.shifts_per_iteration; ++attempt) {
    if (!factor() || !w_.factor.solve(-w_.here.stationarity, w_.step)) {
      damping_.grow(attempt);
      continue;
    }
    slope_ = w_.here.stationarity.dot(w_.step);
    if (slope_ < 0.0 && search() && take()) {
      report_.shift = factored_shift_;
      if (factored_shift_ > 0.0) ++report_.shifted_steps;
      factored_shift_ = -1.0;
      relax();
      return Outcome::moved;
    }
    failure = Outcome::no_decrease;
    damping_.grow(attempt);
  }
  return failure;
}

// Leaves the accepted trial in `trial`, with F and G there in `there`.
bool Newton::search() {
  const double length = w_.step.cwiseQuotient(units_).lpNorm<Eigen::Infinity>();
  const double first = std::min(1.0, options_.largest_step / length);
  const LineSearchResult found = backtrack(
      w_.here.value, slope_, first, [this](double t) { return trial_value(t); },
      options_.line_search);
  if (!found.success) return settle_within_noise();
  step_length_ = found.step;
  full_step_ = found.step == 1.0;
  // Promise of the model at t, with pᵀ(H + σD)p = −Gᵀp.
  const double promised = -slope_ * found.step * (1.0 - 0.5 * found.step);
  agreement_ = (w_.here.value - found.value) / promised;
  return true;
}

// F at m + t p, then steps with the same factor from there, each kept as long as F falls.
double Newton::trial_value(double t) {
  w_.trial = m_ + t * w_.step;
  evaluate(w_.trial, Order::gradient, w_.there);
  for (int k = 0; k < options_.corrections && finite(w_.there); ++k) {
    if (norm(w_.there.stationarity) < options_.tolerance) break;
    if (!w_.factor.solve(-w_.there.stationarity, w_.correction)) break;
    const double length = w_.correction.cwiseQuotient(units_).lpNorm<Eigen::Infinity>();
    w_.corrected = w_.trial + std::min(1.0, options_.largest_step / length) * w_.correction;
    evaluate(w_.corrected, Order::gradient, w_.probe);
    const double gain = w_.there.value - w_.probe.value;
    if (!finite(w_.probe) || !(gain > 0.0)) break;
    std::swap(w_.trial, w_.corrected);
    exchange(w_.there, w_.probe);
    const double fallen = w_.here.value - w_.there.value;
    if (fallen > 0.0 && gain < options_.worthwhile * fallen) break;
  }
  return w_.there.value;
}

// Close to the minimum F cannot tell points apart any more, but G can: a full step that leaves F
// where it is, to rounding, and halves G is progress.
bool Newton::settle_within_noise() {
  if (-slope_ > 1e3 * noise()) return false;
  w_.trial = m_ + w_.step;
  evaluate(w_.trial, Order::gradient, w_.there);
  if (!finite(w_.there) || std::abs(w_.there.value - w_.here.value) > noise()) return false;
  if (norm(w_.there.stationarity) > 0.5 * norm(w_.here.stationarity)) return false;
  step_length_ = 1.0;
  full_step_ = true;
  agreement_ = 1.0;
  return true;
}

// Moves to `trial` if all derivatives are finite there.
bool Newton::take() {
  evaluate(w_.trial, Order::hessian, w_.there);
  if (!finite(w_.there) || !finite_hessian(w_.there)) return false;
  std::swap(m_, w_.trial);
  exchange(w_.here, w_.there);
  return true;
}

void Newton::relax() {
  if (!full_step_) {
    if (step_length_ < 0.25) damping_.grow();
    return;
  }
  if (agreement_ > 0.5) damping_.decay();
  if (agreement_ < 0.1) damping_.grow();
}

bool Newton::stagnated() const {
  const int window = options_.stagnation_window;
  if (window <= 0 || report_.iterations < window) return false;
  const double before = history_[history_.size() - 1 - window];
  return before - w_.here.value < options_.stagnation_decrease * std::abs(before);
}

// F will stay above the ceiling: what is still to come is taken to be less than four times the
// decrease of the last three steps.
bool Newton::beyond_ceiling() const {
  if (!(w_.here.value > options_.value_ceiling) || report_.iterations < 4) return false;
  const double recent = history_[history_.size() - 4] - w_.here.value;
  return w_.here.value - 4.0 * recent > options_.value_ceiling;
}

// G vanishes here; only the exact factor shows whether it is a minimum.
SolveReport Newton::certify() {
  damping_.drop();
  return finish(factor() ? SolveStatus::converged : SolveStatus::not_a_minimum);
}

SolveReport Newton::finish(SolveStatus status) {
  report_.status = status;
  report_.value = w_.here.value;
  report_.history = history_;
  report_.stationarity = w_.here.stationarity.size() == units_.size()
                             ? norm(w_.here.stationarity)
                             : std::numeric_limits<double>::quiet_NaN();
  report_.exact_factor = factored_shift_ == 0.0 && w_.factor.positive();
  finished_ = true;
  keep_state();
  return report_;
}

}  // namespace

SolveReport newton(CostFunction& cost, const VectorXd& s, VectorXd& m, const NewtonOptions& options,
                   NewtonWorkspace& workspace) {
  return Newton(cost, s, m, options, workspace).run();
}

SolveReport newton(const Objective& objective, const VectorXd& s, VectorXd& m,
                   const NewtonOptions& options) {
  ObjectiveCost cost(objective);
  NewtonWorkspace workspace;
  return newton(cost, s, m, options, workspace);
}

}  // namespace legwright
