// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// A trunk whose frame has another axis than z up, as CAD programs draw it, or x and y that are
/// askew to its hips.
struct TrunkAxes {
  std::string why;              // with what is up, or by how much it is askew, in words
  std::array<double, 4> frame;  // of its axes in those sought: a quaternion w x y z, not normalised
  bool stands;   // in the file's own home pose, which turns the frame upright, or is upright
  bool upright;  // z is up: it is turned about that alone
};

/// Finds that the feet of a robot lie along another axis than −z of the trunk's frame: the home
/// pose stands in the world while the trunk's z axis is level or down; or three legs and more of
/// one build end in one plane square to ±x or ±y, below their hips and the centre of mass along
/// that axis, more of them than do so along z; or two hang at most half as far along z, and do so
/// plainly along one of those axes (two_legs_up.hpp).
/// Where z is up, four hips and more that a plane askew to x and y mirrors turn it about z.
/// Nothing where no such thing is so. Faults of the file are left to its reader.
/// @param xml of all files of the robot, whose main one is `file`
std::optional<TrunkAxes> find_trunk_axes(const std::string& xml, const std::filesystem::path& file);

/// Likewise for a robot that stands in no pose with z up: where four legs and more reach out to all
/// sides square to x or y, with first hinges that turn about that, it is up. Whether it is not down
/// nothing tells.
std::optional<TrunkAxes> find_lying_trunk_axes(const std::string& xml,
                                               const std::filesystem::path& file);

/// The same robot with the frame of its trunk that is sought: what stands in the trunk but its free
/// joint and <inertial> is put into a <frame>, <inertial> is turned, and the trunk and keyframes in
/// which the file's own pose stands are turned back. All other bytes stay.
/// Throws InputError, which teaches what to write by hand, where the trunk or those keyframes are
/// not in the main file.
RobotFiles with_upright_axes(const RobotFiles& files, const TrunkAxes& axes);

}  // namespace legwright
