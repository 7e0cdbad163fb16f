// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "mjcf/propose/home_touches.hpp"

namespace legwright {

/// What a URDF does not say, or says as a placeholder, found in the robot that it describes.
struct UrdfMending {
  /// Torque to which gains go [N m]: what <limit effort> has beyond is a placeholder, or the motor
  /// of a much heavier robot, and its gains could not be played.
  double most_torque = std::numeric_limits<double>::infinity();
  std::vector<BodyTouch> overlapping;  // bodies that pass through each other, as they touch at rest
};

/// A robot as MuJoCo's reader holds it after reading a URDF, written as MJCF: all digits of its
/// numbers, names as they are, nothing that is a default. Bodies in the world that have no mass and
/// carry one other are left out, and the trunk below them gets a free joint.
/// Throws InputError for links that move without mass.
/// @param file the URDF, for messages @param notes gets a sentence for what was added and left out
std::string mjcf_of_spec(mjSpec& spec, const std::filesystem::path& file,
                         const UrdfMending& mending, std::vector<std::string>& notes);

}  // namespace legwright
