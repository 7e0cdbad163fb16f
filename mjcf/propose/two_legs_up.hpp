// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "mjcf/propose/leg_search.hpp"

namespace legwright {

/// Whether a robot on two legs plainly stands as it is held in `data`, so that z is up: both legs
/// hang down stretched (by 0.7 of their length), nothing is lower than the feet, what is no leg has
/// its centre of mass above the hips (by a tenth of the leg's length and more than beside them),
/// and each leg has a hinge about the level line through both hips, about which it steps.
bool plainly_stands_on_two(const mjModel& model, const mjData& data, int trunk,
                           const std::vector<SearchedLeg>& legs);

}  // namespace legwright
