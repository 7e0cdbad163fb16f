// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>

#include "tools/simulate/scene.hpp"

namespace legwright {

/// Whether the servo of a joint gives all it has: the torque at its limit or at what the motor has
/// left at its speed; of a linear actuator the force, because what that makes of torque changes
/// with the pose.
/// @param joint in the trajectory's order
bool is_saturated(const Scene& scene, const mjData& data, std::size_t joint);

}  // namespace legwright
