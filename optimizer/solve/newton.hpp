// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>

#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/checkpoint.hpp"
#include "optimizer/solve/cost_function.hpp"
#include "optimizer/solve/line_search.hpp"
#include "optimizer/solve/status.hpp"

namespace legwright {

/// Knobs of the motion solve. Everything is measured in motion_units(), so σ and steps have no
/// unit.
struct NewtonOptions {
  double tolerance = 1e-6;  // on max |G·unit|
  int max_iterations = 200;

  // The shift σ of (H + σ diag(1/unit²)) p = −G. It is remembered from step to step: a good full
  // step shrinks it, a cut or failed one grows it. So an iteration costs one factorisation wherever
  // H allows it.
  double initial_shift = 0.0;  // σ of the first try
  double seed_shift = 1e-3;    // first σ > 0 when nothing is remembered
  double least_shift = 1e-6;   // below this σ is 0
  double shift_growth = 8.0;   // after a factor that is not positive, or a step that cannot be kept
  double shift_decay = 0.3;    // after a full step whose decrease was as promised
  int shifts_per_iteration = 12;  // factorisations of one iteration

  // The step. A correction is one more step with the same factor, G evaluated anew: at 5 % of the
  // price of an iteration it follows the curved floor of a stiff penalty where the straight step
  // leaves it.
  double largest_step = 1.0;  // max |p/unit| of a first trial: legs, weights, radians
  int corrections = 6;        // at most, after each trial
  double worthwhile = 0.02;   // share of the decrease so far; a correction below it is the last
  LineSearchOptions line_search = {.max_trials = 6};

  // When to give up. F not falling by `stagnation_decrease`, relative, over so many iterations is
  // `iteration_limit` with `stagnated` set; window 0: never.
  int stagnation_window = 0;
  double stagnation_decrease = 1e-4;
  // A solve whose F cannot be expected to come below this one is left with status `stopped`.
  double value_ceiling = std::numeric_limits<double>::infinity();

  /// Called after each step with the number of steps so far and the motion.
  std::function<void(int, const Eigen::VectorXd&)> on_step = {};
  std::function<bool()> go_on = {};  // asked before each step; false: `stopped`
  /// Of this solve: where it is kept how far it is, and where it goes on if that is known. on_step
  /// is not called for steps that were made before.
  Checkpoint checkpoint = {};
};

/// Memory of motion solves. Reused from call to call, so that the pattern is analysed once.
struct NewtonWorkspace {
  HessianFactor factor;  // see SolveReport::exact_factor
  Evaluation here;       // F, G, ∂G/∂m at the returned iterate
  Evaluation there, probe;
  Eigen::VectorXd trial, step, correction, corrected, shift_diagonal;
};

/// m*(s): minimises F(s, ·) from m by Newton with the exact Hessian, line 5 of Algorithm 1, in
/// place. The iterate that is returned is the best that was seen, and always finite. `converged`
/// means max |G·unit| below tolerance and an exact Hessian that factors positive; at a saddle the
/// status is `not_a_minimum`.
[[nodiscard]] SolveReport newton(CostFunction& cost, const Eigen::VectorXd& s, Eigen::VectorXd& m,
                                 const NewtonOptions& options, NewtonWorkspace& workspace);

/// The same for a robot; for callers that solve once.
[[nodiscard]] SolveReport newton(const Objective& objective, const Eigen::VectorXd& s,
                                 Eigen::VectorXd& m, const NewtonOptions& options = {});

}  // namespace legwright
