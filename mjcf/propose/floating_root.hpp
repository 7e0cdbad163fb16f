// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// A trunk that floats by joints of its own in the place of a free one, as libraries of imitation
/// learning have it: three slides and three hinges.
struct SixJointRoot {
  std::string body;
  std::vector<std::string> joints;  // in the order of the file; "" for one without a name
};

/// Finds the one body of the world that moves by three slides whose axes span space and three
/// hinges that do, and carries joints. Nothing where a body has a free joint, or the root is made
/// otherwise. Faults of the file are left to its reader.
/// @param xml of all files of the robot, whose main one is `file`
std::optional<SixJointRoot> find_six_joint_root(const std::string& xml,
                                                const std::filesystem::path& file);

/// The same robot with a free joint in the place of those six, and keyframes in which position,
/// turn and velocity of the trunk are those that they had. The six stay as comments, so that every
/// line is where it was; all other bytes stay.
/// Throws InputError for elements that name one of the six (actuators, sensors, tendons), and for
/// joints or keyframes that are not in the main file.
RobotFiles with_free_root(const RobotFiles& files, const SixJointRoot& root);

}  // namespace legwright
