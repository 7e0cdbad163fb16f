// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/line_search.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

LineSearchResult backtrack(double value, double slope, double first_step,
                           const std::function<double(double)>& phi,
                           const LineSearchOptions& options) {
  LineSearchResult result;
  result.value = value;
  if (!std::isfinite(value) || !std::isfinite(slope) || !(slope < 0.0) || !(first_step > 0.0))
    return result;
  double t = first_step;
  while (result.trials < options.max_trials) {
    const double trial = phi(t);
    ++result.trials;
    // Strictly below as well: what a tiny slope promises may be lost in rounding.
    const double enough = value + options.sufficient_decrease * t * slope;
    if (std::isfinite(trial) && trial < value && trial <= enough) {
      result.success = true;
      result.step = t;
      result.value = trial;
      return result;
    }
    // Minimum of the parabola through φ(0), φ'(0) and φ(t).
    const double bend = trial - value - t * slope;
    const double vertex =
        std::isfinite(bend) && bend > 0.0 ? -0.5 * slope * t / bend : options.least_cut;
    t *= std::clamp(vertex, options.least_cut, options.most_cut);
  }
  return result;
}

}  // namespace legwright
