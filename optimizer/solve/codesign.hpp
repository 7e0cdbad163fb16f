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
#include "optimizer/solve/status.hpp"

namespace legwright {

/// One accepted iterate (s, m*(s)) of Algorithm 1. Iteration 0 is motion-only optimisation of the initial design.
struct DesignIteration {
  int index = 0;
  Eigen::VectorXd s, m;
  double value = 0.0;                    // F(s, m)
  std::vector<TermValue> terms;          // weighted, in registry order; they sum to `value`
  Eigen::VectorXd design_gradient;       // dF/ds by the adjoint, eq (8)
  double projected_gradient_norm = 0.0;  // largest scaled entry, those pushing against a bound left out
  double design_step = 0.0;              // δ₁ that was accepted
  int newton_iterations = 0;             // spent on this iteration, rejected trials included
  SolveStatus motion_status = SolveStatus::iteration_limit;
  double seconds = 0.0;                  // wall time of this iteration
};

struct CodesignOptions {
  int max_iterations = 60;          // design iterations
  int line_search_steps = 8;        // N of Algorithm 1
  int history = 10;                 // L-BFGS pairs
  double design_tolerance = 1e-4;   // on projected_gradient_norm
  double value_tolerance = 1e-5;    // relative decrease of F over three iterations that counts as none
  double motion_tolerance = 1e-4;   // scaled stationarity inside the loop
  double final_tolerance = 1e-6;    // scaled stationarity of the result
  int motion_iterations = 200;      // Newton limit of one motion solve
  bool motion_only = false;         // stop after iteration 0
  /// Called after every accepted iteration, in order; return false to stop (status `stopped`).
  std::function<bool(const DesignIteration&)> on_iteration;
};

/// Wall seconds by phase.
struct CodesignSeconds {
  double total = 0.0, motion = 0.0, adjoint = 0.0, predictor = 0.0;
};

struct CodesignResult {
  SolveStatus status = SolveStatus::iteration_limit;
  DesignIteration initial;  // iteration 0
  DesignIteration best;     // the last and best
  int design_iterations = 0;
  int newton_iterations = 0;  // in all
  int factorisations = 0;
  CodesignSeconds seconds;
};

/// Algorithm 1: L-BFGS on s within hard bounds, exact Newton on m, dF/ds by the adjoint equation (7), (8).
/// Deterministic. Throws std::invalid_argument for a task that does not fit the robot.
[[nodiscard]] CodesignResult codesign(const Objective& objective, const DesignSpace& space,
                                      const CodesignOptions& options = {});

}  // namespace legwright
