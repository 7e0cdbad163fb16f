// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/solve/cost_function.hpp"
#include "optimizer/solve/damping.hpp"
#include "optimizer/solve/task_solver.hpp"

namespace legwright {

/// One task's unknowns mᵢ in a Newton step over all tasks and the design (solve/joint_newton). Each
/// works by itself once s and Δs are given, so blocks may run on threads of their own.
class MotionBlock {
 public:
  /// Keeps a reference to the cost.
  MotionBlock(const WeightedCost& task, const Eigen::VectorXd& first_motion);

  /// Evaluates everything at (s, m). False where something is not finite.
  bool evaluate(const Eigen::VectorXd& s);
  /// The same where that was done before, in another process: not counted.
  bool look_again(const Eigen::VectorXd& s);
  /// Tells the cost again where steps set out from: s of the last evaluate(), and the motion.
  void set_step_base(const Eigen::VectorXd& s) { cost_.set_step_base(s, m_); }
  /// Factors H + σ diag(1/unit²), σ raised until that is positive, and solves for X and y. False
  /// where no σ does.
  bool reduce();
  /// ∂²F/∂s² − BᵀX and ∂F/∂s − Bᵀy.
  Eigen::MatrixXd reduced_hessian() const;
  Eigen::VectorXd reduced_gradient() const;

  /// Takes the design's step. Returns how much of the step a first trial may take, at most 1.
  double set_step(const Eigen::VectorXd& design_step);
  /// Slope of F along (Δs, Δm), and what its part at fixed s promises: ½ Gᵀy.
  double slope(const Eigen::VectorXd& design_step) const;
  double promise() const { return 0.5 * at_.stationarity.dot(y_); }
  /// F at s and m + t Δm, bent and corrected; s is that of the trial.
  double try_step(const Eigen::VectorXd& s, double t);
  /// Makes the last trial the motion.
  void accept() { m_.swap(trial_m_); }

  /// After steps that succeed or not.
  void relax() { damping_.decay(); }
  void damp() { damping_.grow(); }
  void drop_shift() { damping_.drop(); }

  /// All that the next step depends on, but for what evaluate() finds.
  void pass_state(SolveState& state);

  const Eigen::VectorXd& motion() const { return m_; }
  double weight() const { return weight_; }
  double value() const { return at_.value; }
  bool exact() const { return damping_.shift() == 0.0; }
  double stationarity() const { return norm(at_.stationarity); }
  int factorisations() const { return factorisations_; }
  int evaluations() const { return evaluations_; }

 private:
  double norm(const Eigen::VectorXd& g) const {
    return g.cwiseProduct(units_).lpNorm<Eigen::Infinity>();
  }
  void evaluate_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Evaluation& out);
  void bend(const Eigen::VectorXd& s, double t);
  void correct(const Eigen::VectorXd& s);
  void take_probe();

  CostFunction& cost_;
  double weight_;
  const Eigen::VectorXd& units_;
  Eigen::VectorXd m_, y_, step_, trial_m_, other_m_, correction_;
  Eigen::MatrixXd right_, solved_, follow_;  // [B G], H⁻¹[B G], X
  HessianFactor factor_;
  Evaluation at_, trial_, probe_;
  Damping damping_;
  int factorisations_ = 0, evaluations_ = 0;
};

}  // namespace legwright
