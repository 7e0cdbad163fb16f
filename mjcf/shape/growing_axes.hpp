// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>

#include "mjcf/shape/affine.hpp"

namespace legwright {

/// Half extents of a geom of MuJoCo's type along its axes [m]; of a mesh zero.
Eigen::Vector3d half_sizes(int type, const mjtNum* size);

/// The stretch with which each axis of a geom grows, null where it keeps its size: a box along
/// those of its axes that a stretch follows; cylinders and capsules along theirs, if they are
/// placed by `from_to` or make up more than half of what is stretched. Shorter ones are motors and
/// pins.
/// @param axes body ← geom.
std::array<const Stretch*, 3> growing_axes(int type, const Eigen::Vector3d& half,
                                           const Eigen::Matrix3d& axes, bool from_to,
                                           const std::vector<Stretch>& stretches);

}  // namespace legwright
