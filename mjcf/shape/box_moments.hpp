// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <optional>

namespace legwright {

/// Moments of inertia of a body's mass as that of a solid box around the shapes of the body and of
/// what is welded to it, along the body's axes [kg m²]: m/12 (b² + c²). Nothing without shapes.
/// @param data any pose, with the places of bodies and geoms
std::optional<Eigen::Vector3d> box_moments(const mjModel& model, const mjData& data, int body);

}  // namespace legwright
