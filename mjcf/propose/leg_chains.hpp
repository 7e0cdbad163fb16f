// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mjcf/propose/leg_search.hpp"

namespace legwright {

/// Legs: of the chains of two hinges and more those of as many hinges and, to a quarter, one
/// length, that hang about as low as the lowest; of several such groups the largest, of equal ones
/// the longest. A chain alone on a middle line of the trunk that ends up in the air is none.
std::vector<SearchedLeg> legs_of_one_build(const mjModel& model, int trunk, const mjData& data);

}  // namespace legwright
