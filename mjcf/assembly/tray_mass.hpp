// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// What the trunk weighs as `legwright parts` prints it, by default [kg]: the box as a tray, with a
/// cradle for each servo on it, and what these and parts stand on. Sampled, and a little more than
/// that: what links pass through and slots for cables and ties are not taken off.
/// @param scale of the trunk's sizes, with which the places of what is on it go
double tray_mass(const Assembly& assembly, const Eigen::Vector3d& scale = Eigen::Vector3d::Ones());

}  // namespace legwright
