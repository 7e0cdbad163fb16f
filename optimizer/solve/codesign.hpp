// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/status.hpp"
#include "optimizer/solve/task_solver.hpp"

namespace legwright {

/// One accepted iterate (s, m₁*(s) … m_k*(s)) of Algorithm 1, or a point on the way of body and
/// motions together, whose motions are on their way to m*(s), too, and its gradient with them.
/// Iteration 0 is motion-only optimisation of the design that the run starts from.
struct DesignIteration {
  int index = 0;
  Eigen::VectorXd s;
  double value = 0.0;              // Σ wᵢ (Fᵢ + Jᵢ)
  std::vector<TaskIterate> tasks;  // in the order of the costs
  Eigen::VectorXd design_gradient;  // Σ wᵢ d(Fᵢ + Jᵢ)/ds; of Fᵢ alone on the way to its optimum
  Eigen::MatrixXd reduced_hessian;  // d²F/ds² along m*(s); empty where it is not known
  // Largest entry of design_gradient·unit, those that push against a bound left out.
  double projected_gradient_norm = 0.0;
  double design_step = 0.0;    // δ₁ that was accepted
  bool exact_gradient = true;  // of all tasks
  int newton_iterations = 0;   // spent on this iteration by all tasks, rejected trials included
  double seconds = 0.0;        // wall time of this iteration

  /// The worst of the tasks' motion statuses: `converged` only if all are.
  SolveStatus motion_status() const;
};

/// How s is stepped.
enum class DesignMethod {
  joint,   // together with the motions (solve/joint_newton), then as `newton`
  newton,  // by itself, with the exact reduced Hessian where it is known, L-BFGS elsewhere
  lbfgs,   // the paper's
};

struct CodesignOptions : MotionLimits {
  int max_iterations = 60;         // design iterations
  int line_search_steps = 8;       // N of Algorithm 1
  int history = 10;                // L-BFGS pairs
  double design_tolerance = 1e-4;  // on projected_gradient_norm
  double value_tolerance = 1e-5;   // relative decrease of F over three iterations that is none
  DesignMethod method = DesignMethod::joint;
  int threads = 1;  // at most one per task is of use; results do not depend on it

  // Decrease of F that a step needs, as a share of what the gradient promises.
  double sufficient_decrease = 1e-4;
  // Largest change of a parameter, in its natural unit: along steepest descent and as the first
  // trust radius of Newton's method; and in any step.
  double largest_first_change = 0.1, largest_change = 0.3;
  // A task's solve is left early when F_joint could come down only if each other task lost more
  // than this share of its F in one step.
  double largest_task_gain = 0.5;
  bool motion_only = false;   // stop after iteration 0
  bool near_optimum = false;  // the start is near an optimum of F + J: J counts at once, and
                              // Algorithm 1 alone is the shorter way
  /// Called after every accepted iteration, in order; return false to stop (status `stopped`).
  std::function<bool(const DesignIteration&)> on_iteration = {};
  std::function<bool()> go_on = {};  // asked before each iteration; false: stop
};

/// Wall seconds by phase; `motion`, `adjoint` and `predictor` are sums over tasks. The search of
/// body and motions together counts as `motion`.
struct CodesignSeconds {
  double total = 0.0, motion = 0.0, adjoint = 0.0, predictor = 0.0;
};

struct CodesignResult {
  SolveStatus status = SolveStatus::iteration_limit;
  DesignIteration initial;  // iteration 0
  std::vector<std::vector<double>>
      motion_only_traces;  // per task: F by Newton step of iteration 0: the body as it is
  DesignIteration best;    // the last and best
  int design_iterations = 0;
  int newton_iterations = 0;  // in all
  int factorisations = 0;
  int evaluations = 0;      // of F, of any order
  int rejected_trials = 0;  // of the line search over s
  CodesignSeconds seconds;
  std::vector<double> solve_seconds;  // of each motion solve after iteration 0
};

/// min F_joint(s, m₁ … m_k) = Σ wᵢ Fᵢ(s, mᵢ). Algorithm 1: Newton's method or L-BFGS on s within
/// hard bounds, exact Newton on each mᵢ, dF/ds by the adjoint equations (7), (8). Before it, unless
/// the method says otherwise, body and motions are stepped together, from the first motions and
/// from those on the way of iteration 0, and Algorithm 1 sets out from the better end; iterations
/// are then points of that way, a few tenths of a natural unit of s apart. With an outer
/// objective Σ wᵢ (Fᵢ + Jᵢ) is minimised over s, and the motions still minimise Fᵢ: at most half of
/// the iterations go to the optimum of Fᵢ, unless near_optimum, and from there L-BFGS steps s.
/// `converged`: projected gradient below design_tolerance (motion_only: the motions' status).
/// `stalled`: F settled to value_tolerance, or no δ₁ helps even along steepest descent; the best
/// iterate is kept, and its projected_gradient_norm tells how far it is from a minimum.
/// Deterministic. The status says `converged` only with an exact adjoint gradient at a minimum in
/// m.
/// @param start design the run starts from, within the space's bounds; initial_motion of each cost
/// belongs to it.
[[nodiscard]] CodesignResult codesign(const std::vector<WeightedCost>& tasks,
                                      const DesignSpace& space, const Eigen::VectorXd& start,
                                      const CodesignOptions& options = {});

/// One task from the initial design, motion from initial_guess().
[[nodiscard]] CodesignResult codesign(const Objective& objective, const DesignSpace& space,
                                      const CodesignOptions& options = {});

}  // namespace legwright
