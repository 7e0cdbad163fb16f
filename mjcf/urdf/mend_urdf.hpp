// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "mjcf/propose/home_touches.hpp"
#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// What a URDF leaves open and the robot that it describes answers.
struct UrdfMending {
  /// Torque to which gains go [N m], as those of a much larger <limit effort> could not be played,
  /// and that motors without one get.
  double most_torque = std::numeric_limits<double>::infinity();
  std::vector<BodyTouch> overlapping;  // bodies that pass through each other, as they touch at rest
  /// Moments about the centre of mass of links whose own cannot be theirs, by name [kg m²].
  std::map<std::string, Eigen::Vector3d> moments;
};

/// Gains go to twice the torque with which stretched legs carry the robot; bodies that touch in its
/// home pose overlap; links without moments of inertia, and those of much larger bodies
/// (wide_inertias()), get the moments of a box around their shape.
/// @param without_moments links of which mjcf_of_spec() tells that they have none
UrdfMending mending_of(const RobotModel& robot, const std::vector<std::string>& without_moments);

/// The trunk of a robot as MuJoCo's reader holds it, with links that MuJoCo compiles: bodies in the
/// world that have no mass and carry one other are passed over, links that move without mass get
/// that of the heaviest link fixed to them, links that float below others are fixed to them,
/// moments that no body has become their mean.
/// Throws InputError for links that still move without mass.
/// @param file the URDF, for messages @param notes gets a sentence for what was mended
mjsBody& mend_bodies(mjSpec& spec, const std::filesystem::path& file,
                     std::vector<std::string>& notes);

/// Moments about the centre of mass in the axes of the link [kg m²].
Eigen::Matrix3d inertia_of_link(const mjsBody& body);

}  // namespace legwright
