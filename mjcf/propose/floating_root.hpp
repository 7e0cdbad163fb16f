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
  std::vector<std::string> joints;    // in the order of the file; "" for one without a name
  std::vector<std::string> carriers;  // bodies between world and trunk with joints of the six
  std::vector<std::string> geoms;     // of the carriers
  int first = 0;                      // id of the first joint; the others are next to it
};

/// Finds the one body that moves in the world by three slides whose axes span space and three
/// hinges that do, and carries joints: all on one body, or on a chain of bodies that weigh next to
/// nothing and touch nothing. Nothing where a body has a free joint, or the root is made otherwise.
/// Faults of the file are left to its reader.
/// @param xml of all files of the robot, whose main one is `file`
std::optional<SixJointRoot> find_six_joint_root(const std::string& xml,
                                                const std::filesystem::path& file);

/// The same robot with a free joint in the place of those six, and keyframes in which position,
/// turn and velocity of the trunk are those that they had. The six, and bodies that carried the
/// trunk, stay as comments, so that every line is where it was; all other bytes stay but for place
/// and class of a trunk that was carried. Cameras, lights and sites of its carriers move into it,
/// where they are seen in the same place while all of the six are at rest.
/// Throws InputError for elements that name one of the six (actuators, sensors, tendons) or a
/// carrier, for what else stands in carriers, and for joints or keyframes that are not in the main
/// file.
RobotFiles with_free_root(const RobotFiles& files, const SixJointRoot& root);

}  // namespace legwright
