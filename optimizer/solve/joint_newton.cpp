// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/joint_newton.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "optimizer/base/parallel.hpp"
#include "optimizer/solve/lbfgs.hpp"
#include "optimizer/solve/motion_block.hpp"
#include "optimizer/solve/reduced_step.hpp"
#include "optimizer/solve/trust_region.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kAttempts = 14;  // to find a step, each with more damping
constexpr int kCuts = 6;       // of one step
constexpr double kCut = 0.4;
constexpr double kSufficientDecrease = 1e-4;
constexpr double kLeastTrust = 1e-6;        // where no step is found
constexpr double kLeastUsefulTrust = 1e-4;  // after a step
// A failed step is laid to the motions, or to the design, only where they promised this share.
constexpr double kBlame = 0.1;
constexpr double kValueRounding = 1e-12;  // relative: F does not tell such points apart

/// What one Newton step of all unknowns promises.
struct JointStep {
  VectorXd design;
  double slope = 0.0;                        // of F along the whole step
  double by_motions = 0.0, by_design = 0.0;  // decreases of the model
  double first = 1.0;                        // first trial of t

  bool blames_motions() const { return by_motions > kBlame * by_design; }
  bool blames_design() const { return by_design > kBlame * by_motions; }
};

class JointNewton {
 public:
  JointNewton(const std::vector<WeightedCost>& tasks, const DesignBox& box, const VectorXd& start,
              const std::vector<VectorXd>& motions, const JointNewtonOptions& options,
              const Checkpoint& checkpoint)
      : options_(options),
        box_(box),
        s_(start),
        trust_{options.first_trust, options.largest_trust, kLeastUsefulTrust},
        checkpoint_(checkpoint),
        origin_(start.squaredNorm()) {
    for (std::size_t k = 0; k < tasks.size(); ++k) {
      blocks_.push_back(std::make_unique<MotionBlock>(tasks[k], motions.at(k)));
      origin_ += motions.at(k).squaredNorm();
    }
  }

  /// Goes on until so many iterations have been made in all.
  void run(int iterations);
  /// Σ wᵢ Fᵢ, infinite where that or a derivative is not finite.
  double value() const {
    return result_.status == SolveStatus::not_finite ? std::numeric_limits<double>::infinity()
                                                     : value_;
  }
  JointNewtonResult take() {
    const bool known = !result_.path.empty() && result_.status != SolveStatus::not_finite;
    if (known && value_ < result_.best().value) tell();
    return std::move(result_);
  }
  const JointNewtonResult& result() const { return result_; }

 private:
  SolveStatus search(int iterations);
  void pass_state(SolveState& state);
  void take_up();
  void keep_state();
  bool for_all(const std::function<bool(MotionBlock&)>& work) const;
  bool look();
  bool reduce();
  bool stationary() const;
  bool at_minimum() const;
  bool stagnated() const;
  bool move();
  JointStep step() const;
  bool search_along(const JointStep& step);
  bool acceptable(double value, double promised) const;
  void adapt(const JointStep& step, double t, double agreement);
  bool back_off(const JointStep& step);
  JointPoint here() const;
  void tell();
  double change_since_told() const;

  const JointNewtonOptions& options_;
  const DesignBox box_;
  std::vector<std::unique_ptr<MotionBlock>> blocks_;
  VectorXd s_;
  double value_ = 0.0;
  TrustRegion trust_;
  MatrixXd hessian_;
  VectorXd gradient_;  // reduced, as the Hessian
  std::vector<double> history_;
  JointNewtonResult result_;
  Checkpoint checkpoint_;
  double origin_;  // tells (s, first motions): a state is of no use to a search from elsewhere
};

void JointNewton::run(int iterations) {
  if (result_.status != SolveStatus::iteration_limit) return;
  if (checkpoint_ && options_.go_on && !options_.go_on())
    checkpoint_ = {};  // what begins after a stop is not what a whole run does
  if (history_.empty()) take_up();
  if (!history_.empty())  // another search may have used the costs in between
    for (const auto& block : blocks_) block->set_step_base(s_);
  if (result_.status == SolveStatus::iteration_limit) {
    const SolveStatus status = search(iterations);
    if (status != SolveStatus::stopped) result_.status = status;
    keep_state();
    result_.status = status;
  }
  result_.factorisations = result_.evaluations = 0;
  for (const auto& block : blocks_) {
    result_.factorisations += block->factorisations();
    result_.evaluations += block->evaluations();
  }
}

// All that the next iteration depends on, but for what is evaluated again.
void JointNewton::pass_state(SolveState& state) {
  state(s_);
  state(value_);
  state(trust_.radius);
  state(history_);
  state(result_.status);
  state(result_.iterations);
  for (const auto& block : blocks_) block->pass_state(state);
  state.size_of(result_.path);
  for (JointPoint& point : result_.path) {
    state(point.s);
    state(point.value);
    state.size_of(point.motions);
    for (VectorXd& motion : point.motions) state(motion);
  }
}

// Where a process before this one had come to something.
void JointNewton::take_up() {
  if (checkpoint_.take_up([this](SolveState& state) { pass_state(state); }, origin_))
    (void)for_all([&](MotionBlock& block) { return block.look_again(s_); });
}

void JointNewton::keep_state() {
  checkpoint_.keep([this](SolveState& state) { pass_state(state); }, origin_);
}

bool JointNewton::for_all(const std::function<bool(MotionBlock&)>& work) const {
  std::vector<char> done(blocks_.size());
  parallel_for(static_cast<int>(blocks_.size()), options_.threads, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    done[k] = work(*blocks_[k]) ? 1 : 0;
  });
  return std::all_of(done.begin(), done.end(), [](char c) { return c != 0; });
}

// @param iterations that may have been made at the end
SolveStatus JointNewton::search(int iterations) {
  if (history_.empty() && !look()) return SolveStatus::not_finite;
  while (result_.iterations < iterations) {
    if (checkpoint_.due()) keep_state();
    if (options_.go_on && !options_.go_on()) return SolveStatus::stopped;
    if (!reduce()) return SolveStatus::stalled;
    if (stationary()) {
      for (const auto& block : blocks_) block->drop_shift();
      if (!reduce()) return SolveStatus::stalled;
      if (at_minimum()) return SolveStatus::converged;
    }
    if (stagnated() || !move()) return SolveStatus::stalled;
    ++result_.iterations;
    if (!look()) return SolveStatus::not_finite;
    if (options_.on_step) options_.on_step(here());
  }
  return SolveStatus::iteration_limit;
}

// Evaluates everything at the point at hand.
bool JointNewton::look() {
  if (!for_all([&](MotionBlock& block) { return block.evaluate(s_); })) return false;
  value_ = 0.0;
  for (const auto& block : blocks_) value_ += block->weight() * block->value();
  history_.push_back(value_);
  if (result_.path.empty() || change_since_told() >= options_.told_change) tell();
  return true;
}

bool JointNewton::reduce() {
  if (!for_all([](MotionBlock& block) { return block.reduce(); })) return false;
  hessian_.setZero(s_.size(), s_.size());
  gradient_.setZero(s_.size());
  for (const auto& block : blocks_) {
    hessian_ += block->weight() * block->reduced_hessian();
    gradient_ += block->weight() * block->reduced_gradient();
  }
  return true;
}

bool JointNewton::stationary() const {
  const bool motions = std::all_of(blocks_.begin(), blocks_.end(), [&](const auto& block) {
    return block->stationarity() < options_.motion_tolerance;
  });
  return motions && projected_gradient_norm(s_, gradient_, box_.lower, box_.upper, box_.scale) <
                        options_.design_tolerance;
}

// Only exact factors show that a stationary point is a minimum.
bool JointNewton::at_minimum() const {
  return stationary() && std::all_of(blocks_.begin(), blocks_.end(),
                                     [](const auto& block) { return block->exact(); });
}

bool JointNewton::stagnated() const {
  const auto window = static_cast<std::size_t>(options_.stagnation_window);
  if (history_.size() <= window) return false;
  const double before = history_[history_.size() - 1 - window];
  return before - value_ < options_.stagnation_decrease * std::abs(before);
}

// One accepted step; damping grows until there is one.
bool JointNewton::move() {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const JointStep next = step();
    if (next.slope < 0.0 && search_along(next)) return true;
    if (back_off(next) && !reduce()) return false;
  }
  return false;
}

JointStep JointNewton::step() const {
  JointStep out;
  out.design = reduced_newton_step(hessian_, gradient_, s_, box_, trust_.radius);
  out.by_design = -model_change(hessian_, gradient_, out.design);
  if (!(out.by_design > 0.0)) {
    out.design = steepest_step(hessian_, gradient_, s_, box_, trust_.radius);
    out.by_design = -model_change(hessian_, gradient_, out.design);
  }
  for (const auto& block : blocks_) {
    out.first = std::min(out.first, block->set_step(out.design));
    out.slope += block->weight() * block->slope(out.design);
    out.by_motions += block->weight() * block->promise();
  }
  return out;
}

bool JointNewton::search_along(const JointStep& step) {
  double t = step.first;
  for (int k = 0; k < kCuts; ++k, t *= kCut) {
    const VectorXd s = (s_ + t * step.design).cwiseMax(box_.lower).cwiseMin(box_.upper);
    std::vector<double> values(blocks_.size());
    parallel_for(static_cast<int>(blocks_.size()), options_.threads, [&](int i) {
      const auto j = static_cast<std::size_t>(i);
      values[j] = blocks_[j]->try_step(s, t);
    });
    double value = 0.0;
    for (std::size_t j = 0; j < values.size(); ++j) value += blocks_[j]->weight() * values[j];
    if (!acceptable(value, -t * step.slope)) continue;
    const double whole = step.by_motions + step.by_design;  // of t = 1
    const double promised = t * (-step.slope - t * (-step.slope - whole));
    s_ = s;
    for (const auto& block : blocks_) block->accept();
    adapt(step, t, (value_ - value) / promised);
    return true;
  }
  return false;
}

bool JointNewton::acceptable(double value, double promised) const {
  if (!std::isfinite(value)) return false;
  return value <= value_ - kSufficientDecrease * promised ||
         std::abs(value - value_) < kValueRounding * std::abs(value_);
}

// @param agreement decrease over what the model promised; corrections make it more than one
void JointNewton::adapt(const JointStep& step, double t, double agreement) {
  const double change = t * step.design.cwiseQuotient(box_.scale).lpNorm<Eigen::Infinity>();
  if (t == 1.0) {
    for (const auto& block : blocks_) {
      if (agreement > 0.5) block->relax();
      if (agreement < 0.1 && step.blames_motions()) block->damp();
    }
    trust_.adapt(agreement, change);
  } else if (t < 0.25) {
    if (step.blames_motions())
      for (const auto& block : blocks_) block->damp();
    if (step.blames_design()) trust_.radius = std::max(0.5 * trust_.radius, kLeastUsefulTrust);
  }
}

// After a step that failed. @return whether the factors are others now
bool JointNewton::back_off(const JointStep& step) {
  const bool uphill = !(step.slope < 0.0);
  const bool damped = uphill || step.blames_motions();
  if (damped)
    for (const auto& block : blocks_) block->damp();
  if (uphill || step.blames_design()) trust_.radius = std::max(0.3 * trust_.radius, kLeastTrust);
  return damped;
}

double JointNewton::change_since_told() const {
  return (s_ - result_.path.back().s).cwiseQuotient(box_.scale).lpNorm<Eigen::Infinity>();
}

JointPoint JointNewton::here() const {
  JointPoint point{s_, {}, value_};
  for (const auto& block : blocks_) point.motions.push_back(block->motion());
  return point;
}

void JointNewton::tell() { result_.path.push_back(here()); }

}  // namespace

JointNewtonResult joint_newton(const std::vector<WeightedCost>& tasks, const DesignBox& box,
                               const VectorXd& start,
                               const std::vector<std::vector<VectorXd>>& motions,
                               const JointNewtonOptions& options) {
  std::vector<std::unique_ptr<JointNewton>> searches;
  searches.reserve(motions.size());
  for (const std::vector<VectorXd>& first : motions) {
    const Checkpoint checkpoint = options.checkpoint.in(static_cast<int>(searches.size()));
    searches.push_back(
        std::make_unique<JointNewton>(tasks, box, start, first, options, checkpoint));
  }
  if (searches.empty()) return {};
  if (searches.size() > 1)
    for (const auto& search : searches)
      search->run(std::min(options.scout_iterations, options.max_iterations));
  JointNewton& best =
      **std::min_element(searches.begin(), searches.end(),
                         [](const auto& a, const auto& b) { return a->value() < b->value(); });
  best.run(options.max_iterations);
  JointNewtonResult out = best.take();
  for (const auto& search : searches) {
    if (search.get() == &best) continue;
    out.iterations += search->result().iterations;
    out.factorisations += search->result().factorisations;
    out.evaluations += search->result().evaluations;
  }
  return out;
}

}  // namespace legwright
