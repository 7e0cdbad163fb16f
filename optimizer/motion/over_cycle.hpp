// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace legwright {

/// A quantity given at n evenly spaced times of the cycle, values[k] at phase k/n, straight in
/// between and from the last back to the first: its value at any phase. With as many values as the
/// gait has knots these are the values at the knots. Needs at least one value.
template <typename Value>
Value over_cycle(const std::vector<Value>& values, double phase) {
  const auto count = static_cast<double>(values.size());
  const double place = (phase - std::floor(phase)) * count;
  const double nearest = std::round(place);  // 1/3 of 3 values is the second, whatever the rounding
  const bool met = std::abs(place - nearest) < 1e-9 * count;
  const auto before = static_cast<std::size_t>(met ? nearest : std::floor(place));
  const double share = met ? 0.0 : place - std::floor(place);
  const Value& from = values[before % values.size()];
  const Value& to = values[(before + 1) % values.size()];
  return (1.0 - share) * from + share * to;
}

}  // namespace legwright
