// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace legwright {

/// How a solve ended. Never `converged` next to a number that is not finite.
enum class SolveStatus {
  converged,        // gradient below tolerance, exact Hessian positive definite
  iteration_limit,  // stopped by a limit, iterate usable
  stalled,          // no step improves any more; best iterate kept
  not_a_minimum,    // exact Hessian not positive definite: no adjoint
  not_finite,       // F or a derivative is NaN or infinite at the start
  stopped,          // the caller asked to stop, or F cannot come below the ceiling it set
};

constexpr std::string_view to_string(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::iteration_limit:
      return "iteration_limit";
    case SolveStatus::stalled:
      return "stalled";
    case SolveStatus::not_a_minimum:
      return "not_a_minimum";
    case SolveStatus::not_finite:
      return "not_finite";
    case SolveStatus::stopped:
      return "stopped";
  }
  return "unknown";
}

/// What one motion solve did. Counts are exact and repeatable; there is no time in it.
struct SolveReport {
  SolveStatus status = SolveStatus::iteration_limit;
  int iterations = 0;         // accepted Newton steps
  int factorisations = 0;     // numeric ones, failed and certifying ones included
  int evaluations = 0;        // of F, of any order
  double value = 0.0;         // F at the returned iterate
  double stationarity = 0.0;  // max |G·unit| there
  double shift = 0.0;         // σ of the last step taken; 0: a pure Newton step
  int shifted_steps = 0;      // steps that needed σ > 0
  bool exact_factor =
      false;  // the workspace's factor is that of the exact Hessian at the returned iterate
  bool stagnated = false;       // `iteration_limit` because F hardly fell any more
  std::vector<double> history;  // F at the start and after each accepted step
};

}  // namespace legwright
