// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/limbs.hpp"
#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Lengths of left and right links that differ by less are tied in proportion; others are not tied.
inline constexpr double kTiedInProportion = 0.05;  // of the link

/// Why the axes of two joints are no mirror images in the home pose; empty where they are.
/// @param model the robot's. @param twin the joint on the other side
std::string unmirrored_axes(const RobotModel& robot, const mjModel& model, const Joint& joint,
                            const Joint& twin, Across across);

/// What looks like a slip in the file, as left and right of a robot differ by it: legs that would
/// be a pair but for a hand's breadth, links of a pair whose lengths differ by more than
/// kTiedInProportion, axes of a pair that are no mirror images. A sentence each.
std::vector<std::string> unlike_sides(const RobotModel& robot, const std::vector<Limb>& limbs,
                                      Across across);
/// Likewise, of the robot as it faces.
std::vector<std::string> unlike_sides(const RobotModel& robot);

/// What is taken for mirror images though the file draws it some tenths of a millimetre or more
/// apart: links whose lengths are tied in proportion, and feet. A sentence on all; empty where
/// there are none.
std::string tied_though_unlike(const RobotModel& robot, const std::vector<Limb>& limbs,
                               Across across);

}  // namespace legwright
