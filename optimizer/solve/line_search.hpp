// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace legwright {

struct LineSearchOptions {
  double sufficient_decrease =
      1e-4;                // share of the slope's promise that counts as success (Armijo)
  int max_trials = 10;     // values of the step that are tried, the first included
  double least_cut = 0.1;  // the next step is between these shares of the last one,
  double most_cut = 0.5;   //   placed by the parabola through what is known
};

struct LineSearchResult {
  bool success = false;
  double step = 0.0;   // 0 without success
  double value = 0.0;  // at `step`; the starting value without success
  int trials = 0;
};

/// Backtracks from `first_step` until φ(t) ≤ φ(0) + c t φ'(0). A value that is not finite is a
/// failed trial like any other. Fails at once where the direction does not go down (slope ≥ 0 or
/// not finite).
/// @param value φ(0). @param slope φ'(0). @param phi its last call was made with the returned step.
[[nodiscard]] LineSearchResult backtrack(double value, double slope, double first_step,
                                         const std::function<double(double)>& phi,
                                         const LineSearchOptions& options = {});

}  // namespace legwright
