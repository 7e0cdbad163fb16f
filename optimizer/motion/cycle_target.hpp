// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "optimizer/motion/over_cycle.hpp"

namespace legwright {

/// What one quantity of eq (10) shall be over the cycle, and how much it counts beside the others
/// of its term.
struct CycleTarget {
  std::vector<double> phases;  // of the values, rising, in [0, 1); empty: evenly spaced from 0
  std::vector<double> values;  // [m] or [rad]; empty: there is no target
  double weight = 1.0;         // multiplies the term's own

  bool is_given() const { return !values.empty() && weight > 0.0; }

  /// Straight between two values, and from the last on to the first of the next cycle. Needs a
  /// value.
  double at(double phase) const {
    if (phases.empty()) return over_cycle(values, phase);
    const double place = phase - std::floor(phase);
    const auto found = std::upper_bound(phases.begin(), phases.end(), place);
    const auto next = static_cast<std::size_t>(found - phases.begin()) % phases.size();
    const std::size_t last = (next + phases.size() - 1) % phases.size();
    const double gap = phases[next] - phases[last];
    const double length = gap > 0.0 ? gap : gap + 1.0;  // over the end of the cycle
    const double gone = place - phases[last];
    const double share = (gone < 0.0 ? gone + 1.0 : gone) / length;
    return (1.0 - share) * values[last] + share * values[next];
  }
};

/// The target of a foot or joint; null where the task gives it none.
inline const CycleTarget* target_of(const std::vector<CycleTarget>& targets, int index) {
  const auto place = static_cast<std::size_t>(index);
  return place < targets.size() && targets[place].is_given() ? &targets[place] : nullptr;
}

}  // namespace legwright
