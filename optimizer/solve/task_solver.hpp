// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
#include <vector>

#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/cost_function.hpp"
#include "optimizer/solve/newton.hpp"
#include "optimizer/solve/status.hpp"

namespace legwright {

/// One task's share of F_joint(s, m₁ … m_k) = Σ wᵢ Fᵢ(s, mᵢ).
struct WeightedCost {
  CostFunction* cost = nullptr;    // Fᵢ; must live longer
  double weight = 1.0;             // wᵢ > 0; 0 is fine where the design stays (motion_only)
  Eigen::VectorXd initial_motion;  // for the design that the run starts from
  /// Outer objective Jᵢ ≠ Fᵢ, or null: the motion still minimises Fᵢ, the design minimises
  /// Σ wᵢ (Fᵢ + Jᵢ). Must live longer.
  CostFunction* outer = nullptr;
};

/// The state of one task at an accepted design.
struct TaskIterate {
  Eigen::VectorXd m;                // m*(s)
  double value = 0.0;               // F(s, m), unweighted by the task's weight
  double outer_value = 0.0;         // J(s, m); 0 without an outer objective
  std::vector<TermValue> terms;     // of F, in registry order; they sum to `value`
  Eigen::VectorXd design_gradient;  // d(F + J)/ds by the adjoint, eq (8)
  Eigen::MatrixXd sensitivity;      // dm/ds, eq (4); empty where it was not computed
  bool exact_gradient = true;  // false: H was not positive definite, the gradient is ∂F/∂s alone
  double adjoint_residual = 0.0;  // of eq (7); 0 without an exact gradient
  double stationarity = 0.0;      // max |G·unit|
  int newton_iterations = 0;      // spent on this iterate, rejected trials included
  SolveStatus motion_status = SolveStatus::iteration_limit;
};

/// Limits of the motion solves of a co-design run.
struct MotionLimits {
  double motion_tolerance = 1e-4;  // scaled stationarity inside the design loop
  double final_tolerance = 1e-6;   // scaled stationarity of iteration 0 and of the result
  int motion_iterations = 200;     // Newton limit of one motion solve
  int trial_iterations = 40;       // the same for a trial of the line search
  // A motion solve is left, as `iteration_limit`, when F falls by less than this share over so many
  // iterations: a robot that cannot do the task has no good motion to converge to.
  int stagnation_window = 10;
  double stagnation_decrease = 1e-5;
  NewtonOptions newton = {};   // rules of the motion solve; tolerance and limits are those above
  Checkpoint checkpoint = {};  // place of the search, in which each solve has its own
};

/// Counts and wall seconds of one task's solves.
struct TaskEffort {
  int newton_iterations = 0, factorisations = 0, evaluations = 0;
  double motion_seconds = 0.0, adjoint_seconds = 0.0, predictor_seconds = 0.0;
  std::vector<double> solve_seconds;  // of each motion solve, in order
};

/// m*(s) of one task along a path of designs: solves, predicts, differentiates. Tasks share nothing
/// but s, so each solver may run on a thread of its own.
class TaskSolver {
 public:
  /// Keeps references to the costs and limits. @param checkpoint of its solves
  TaskSolver(const WeightedCost& task, const MotionLimits& limits, Checkpoint checkpoint = {});

  /// Of the solves from here on.
  void set_checkpoint(Checkpoint checkpoint) {
    checkpoint_ = std::move(checkpoint);
    solves_ = 0;
  }
  /// Iteration 0: motion-only optimisation at s. False where F is not finite.
  bool start(const Eigen::VectorXd& s);
  /// First-order motion of another design, eq (4), bent to eq (12), or the iterate's own where that
  /// has no more F there. Needs differentiate() at the iterate.
  Eigen::VectorXd predicted_motion(const Eigen::VectorXd& s);
  /// Solves for the motion of another design, from the predicted one; now() stays as it is.
  /// @param ceiling F above it is of no use: the solve may be left early. @return F + J there;
  /// infinite where there is no finite motion; J counts once minimise_outer() is called.
  double try_design(const Eigen::VectorXd& s, double ceiling);
  /// Makes the last trial the iterate; undo() takes that back.
  void accept();
  void undo() { accept(); }  // the two points change places
  /// Starts counting the Newton iterations of the next iterate.
  void begin_iteration() { now_.newton_iterations = 0; }
  /// d(F + J)/ds at the iterate, J where it counts, eqs (7), (8). Without a minimum in m there is
  /// no adjoint: then the gradient at fixed m, ∂F/∂s, still leads down. False where a derivative is
  /// not finite.
  bool differentiate();
  /// d²F/ds² along m*(s): F_ss − F_msᵀ H⁻¹ F_ms, exact where G = 0. False without an exact factor.
  bool reduced_hessian(Eigen::MatrixXd& hessian);
  /// Solves the iterate's motion to the final tolerance.
  void polish();
  /// Makes a design and its motion, found elsewhere, the iterate. False where F or J is not finite.
  bool adopt(const Eigen::VectorXd& s, const Eigen::VectorXd& m);

  const TaskIterate& now() const { return now_; }
  double weight() const { return task_.weight; }
  bool has_outer() const { return task_.outer != nullptr; }
  /// From now on the design minimises F + J, before F alone.
  void minimise_outer() { outer_counts_ = has_outer(); }
  bool outer_counts() const { return outer_counts_; }
  /// F, and J where it counts, at the iterate.
  double searched_value() const { return now_.value + (outer_counts_ ? now_.outer_value : 0.0); }
  const TaskEffort& effort() const { return effort_; }
  const WeightedCost& task() const { return task_; }
  /// F by Newton step of iteration 0.
  const std::vector<double>& motion_only_trace() const { return motion_only_trace_; }
  /// The motion after ten steps of iteration 0: what a body that cannot do the task does before its
  /// motion gives way to that. Empty where there were fewer.
  const Eigen::VectorXd& early_motion() const { return early_motion_; }

 private:
  SolveReport solve(const Eigen::VectorXd& s, Eigen::VectorXd& m, NewtonOptions options);
  NewtonOptions options(double tolerance, int limit) const;
  void restore_shifted_factor();
  double outer_value(const Eigen::VectorXd& s, const Eigen::VectorXd& m);

  /// A design with its motion, and what Newton's method left behind there.
  struct Point {
    Eigen::VectorXd s, m;
    double value = 0.0, outer_value = 0.0;
    SolveStatus status = SolveStatus::iteration_limit;
    bool factor_exact = false;
    double shift = 0.0;
  };
  void take(const SolveReport& report, Point& point) const;
  void show_here();

  WeightedCost task_;
  bool outer_counts_ = false;
  const MotionLimits& limits_;
  NewtonWorkspace workspace_;  // its factor belongs to trial_
  HessianFactor factor_;       // of ∂G/∂m at here_
  Point here_, trial_;
  Evaluation at_, outer_at_, probe_;  // at_: everything at here_, Order::design
  TaskIterate now_;
  TaskEffort effort_;
  std::vector<double> motion_only_trace_;
  Eigen::VectorXd early_motion_;
  Checkpoint checkpoint_;
  int solves_ = 0;  // so far: the names of their checkpoints
};

using TaskSolvers = std::vector<std::unique_ptr<TaskSolver>>;

/// How high each Fᵢ, with Jᵢ where that counts, may be so that F_joint can still come down to
/// `total` although each other task gains no more than that share of its F.
std::vector<double> ceilings(const TaskSolvers& solvers, double total, double largest_gain);

}  // namespace legwright
