// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace legwright {

/// What a design that was played costs.
struct PlayedCost {
  bool pass = false;
  double F = 0.0;
};

/// Of several designs that pass and cost about as much, the cheapest whose cycle is stable: it is
/// better than a cheaper one that passes while nothing disturbs it.
/// @param least F of the best that passes @param multiplier the largest Floquet multiplier of one
/// (validate/floquet); asked of the cheapest first, of none after one below 1
/// @return which of them; nothing where there is no choice, or none is stable
std::optional<std::size_t> cheapest_stable(const std::vector<PlayedCost>& played, double least,
                                           const std::function<double(std::size_t)>& multiplier);

}  // namespace legwright
