// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <utility>
#include <vector>

#include "mjcf/read/structure.hpp"

namespace legwright {

/// Pairs of geoms (trunk, limb), rising, between which MuJoCo makes contacts when the robot is
/// played: contype and conaffinity, <exclude>, <pair>, the filter of bodies next to each other, and
/// the switches of <option>. What rides on the trunk or is held there is the trunk's.
std::vector<std::pair<int, int>> trunk_collisions(const mjModel& model, const Structure& structure);

}  // namespace legwright
