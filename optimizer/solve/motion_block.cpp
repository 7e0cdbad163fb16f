// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/motion_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimizer/solve/newton.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Damping and corrections are those of motion-only solves.
const NewtonOptions kRules;

}  // namespace

MotionBlock::MotionBlock(const WeightedCost& task, const VectorXd& first_motion)
    : cost_(*task.cost),
      weight_(task.weight),
      units_(task.cost->motion_units()),
      m_(first_motion),
      damping_(kRules) {}

void MotionBlock::evaluate_at(const VectorXd& s, const VectorXd& m, Evaluation& out) {
  cost_.evaluate(s, m, Order::gradient, out);
  ++evaluations_;
}

bool MotionBlock::evaluate(const VectorXd& s) {
  ++evaluations_;
  return look_again(s);
}

bool MotionBlock::look_again(const VectorXd& s) {
  cost_.evaluate(s, m_, Order::design, at_);
  set_step_base(s);
  const Eigen::Map<const VectorXd> hessian(at_.hessian_mm.valuePtr(), at_.hessian_mm.nonZeros());
  return std::isfinite(at_.value) && at_.stationarity.allFinite() && at_.partial_s.allFinite() &&
         hessian.allFinite() && at_.hessian_ms.allFinite() && at_.hessian_ss.allFinite();
}

void MotionBlock::pass_state(SolveState& state) {
  state(m_);
  state(factorisations_);
  state(evaluations_);
  damping_.pass_state(state);
}

bool MotionBlock::reduce() {
  const Eigen::Index n = at_.hessian_ms.cols();
  right_.resize(m_.size(), n + 1);
  right_ << at_.hessian_ms, at_.stationarity;
  for (int k = 0; k < kRules.shifts_per_iteration; ++k) {
    ++factorisations_;
    if (factor_.factor(at_.hessian_mm, damping_.diagonal(units_)) &&
        factor_.solve(right_, solved_)) {
      follow_ = solved_.leftCols(n);
      y_ = solved_.col(n);
      return true;
    }
    damping_.grow(k);
  }
  return false;
}

MatrixXd MotionBlock::reduced_hessian() const {
  const MatrixXd hessian = at_.hessian_ss - at_.hessian_ms.transpose() * follow_;
  return 0.5 * (hessian + hessian.transpose());
}

VectorXd MotionBlock::reduced_gradient() const {
  return at_.partial_s - at_.hessian_ms.transpose() * y_;
}

double MotionBlock::set_step(const VectorXd& design_step) {
  step_ = -y_ - follow_ * design_step;
  return std::min(1.0, kRules.largest_step / step_.cwiseQuotient(units_).lpNorm<Eigen::Infinity>());
}

double MotionBlock::slope(const VectorXd& design_step) const {
  return at_.stationarity.dot(step_) + at_.partial_s.dot(design_step);
}

double MotionBlock::try_step(const VectorXd& s, double t) {
  bend(s, t);
  correct(s);
  return trial_.value;
}

// The bent step, or where that leads up the straight one if it is lower.
void MotionBlock::bend(const VectorXd& s, double t) {
  trial_m_ = m_ + t * step_;
  other_m_ = trial_m_;
  cost_.correct_step(s, trial_m_);
  evaluate_at(s, trial_m_, trial_);
  if (trial_.value < at_.value || trial_m_ == other_m_) return;
  evaluate_at(s, other_m_, probe_);
  if (probe_.value < trial_.value || !std::isfinite(trial_.value)) take_probe();
}

// Steps with the same factor from there, each kept as long as F falls.
void MotionBlock::correct(const VectorXd& s) {
  for (int k = 0; k < kRules.corrections && std::isfinite(trial_.value); ++k) {
    if (!factor_.solve(-trial_.stationarity, correction_)) return;
    const double length = correction_.cwiseQuotient(units_).lpNorm<Eigen::Infinity>();
    other_m_ = trial_m_ + std::min(1.0, kRules.largest_step / length) * correction_;
    evaluate_at(s, other_m_, probe_);
    const double gain = trial_.value - probe_.value;
    if (!(gain > 0.0)) return;
    take_probe();
    if (gain < kRules.worthwhile * std::abs(at_.value - trial_.value)) return;
  }
}

// F and G of a gradient's Evaluation; its matrices are not of use here.
void MotionBlock::take_probe() {
  trial_m_.swap(other_m_);
  std::swap(trial_.value, probe_.value);
  trial_.stationarity.swap(probe_.stationarity);
}

}  // namespace legwright
