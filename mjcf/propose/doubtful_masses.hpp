// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Bodies whose <inertial> cannot be that of their shape, as exporters of CAD programs leave them
/// in other units or frames: a centre of mass far beside what the body shows and collides with, or
/// moments of inertia of a much larger one. A sentence for each kind, the worst body first.
std::vector<std::string> doubtful_masses(const RobotModel& robot);

/// The bodies among them whose moments of inertia are those of a much larger one, by name.
std::vector<std::string> wide_inertias(const RobotModel& robot);

/// Moments of inertia of a body's mass as that of a solid box around the shapes of the body and of
/// what is welded to it, along the body's axes [kg m²]: m/12 (b² + c²). Nothing without shapes.
std::optional<Eigen::Vector3d> box_moments(const mjModel& model, int body);

}  // namespace legwright
