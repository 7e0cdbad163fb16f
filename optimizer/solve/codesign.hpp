// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string_view>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/task.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/cost_function.hpp"
#include "optimizer/solve/newton.hpp"
#include "optimizer/solve/status.hpp"

namespace legwright {

/// One accepted iterate (s, m*(s)) of Algorithm 1. Iteration 0 is motion-only optimisation of the
/// initial design.
struct DesignIteration {
  int index = 0;
  Eigen::VectorXd s, m;
  double value = 0.0;               // F(s, m)
  std::vector<TermValue> terms;     // weighted, in registry order; they sum to `value`
  Eigen::VectorXd design_gradient;  // dF/ds by the adjoint, eq (8)
  // Largest entry of design_gradient·unit, those that push against a bound left out.
  double projected_gradient_norm = 0.0;
  double design_step = 0.0;    // δ₁ that was accepted
  bool exact_gradient = true;  // false: H was not positive definite, the gradient is ∂F/∂s alone
  double adjoint_residual = 0.0;  // of eq (7); 0 without an exact gradient
  int newton_iterations = 0;      // spent on this iteration, rejected trials included
  SolveStatus motion_status = SolveStatus::iteration_limit;
  double seconds = 0.0;  // wall time of this iteration
};

struct CodesignOptions {
  int max_iterations = 60;         // design iterations
  int line_search_steps = 8;       // N of Algorithm 1
  int history = 10;                // L-BFGS pairs
  double design_tolerance = 1e-4;  // on projected_gradient_norm
  double value_tolerance = 1e-5;   // relative decrease of F over three iterations that is none
  double motion_tolerance = 1e-4;  // scaled stationarity inside the loop
  double final_tolerance = 1e-6;   // scaled stationarity of iteration 0 and of the result
  int motion_iterations = 200;     // Newton limit of one motion solve
  int trial_iterations = 40;       // the same for a trial of the line search

  // Decrease of F that a step needs, as a share of what the gradient promises.
  double sufficient_decrease = 1e-4;
  // Largest change of a parameter, in its natural unit: along steepest descent, and in any step.
  double largest_first_change = 0.1, largest_change = 0.3;
  // A motion solve is left, as `iteration_limit`, when F falls by less than this share over so many
  // iterations: a robot that cannot do the task has no good motion to converge to.
  int stagnation_window = 10;
  double stagnation_decrease = 1e-5;
  NewtonOptions newton = {};  // rules of the motion solve; tolerance and limits are those above
  bool motion_only = false;   // stop after iteration 0
  /// Called after every accepted iteration, in order; return false to stop (status `stopped`).
  std::function<bool(const DesignIteration&)> on_iteration = {};
};

/// Wall seconds by phase.
struct CodesignSeconds {
  double total = 0.0, motion = 0.0, adjoint = 0.0, predictor = 0.0;
};

struct CodesignResult {
  SolveStatus status = SolveStatus::iteration_limit;
  DesignIteration initial;                // iteration 0
  std::vector<double> motion_only_trace;  // F by Newton step of iteration 0: the body as it is
  DesignIteration best;                   // the last and best
  int design_iterations = 0;
  int newton_iterations = 0;  // in all
  int factorisations = 0;
  int evaluations = 0;      // of F, of any order
  int rejected_trials = 0;  // of the line search over s
  CodesignSeconds seconds;
};

/// Algorithm 1: L-BFGS on s within hard bounds, exact Newton on m, dF/ds by the adjoint equation
/// (7), (8).
/// `converged`: projected gradient below design_tolerance (motion_only: the motion's status).
/// `stalled`: F settled to value_tolerance, or no δ₁ helps even along steepest descent; the best
/// iterate is kept, and its projected_gradient_norm tells how far it is from a minimum.
/// Deterministic. The status says `converged` only with an exact adjoint gradient at a minimum in m.
[[nodiscard]] CodesignResult codesign(const Objective& objective, const DesignSpace& space,
                                      const CodesignOptions& options = {});

/// The same for any F(s, m), from the motion `initial_motion` of the design space.initial().
[[nodiscard]] CodesignResult codesign(CostFunction& cost, const DesignSpace& space,
                                      const Eigen::VectorXd& initial_motion,
                                      const CodesignOptions& options = {});

}  // namespace legwright
