// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "mjcf/propose/module_overlaps.hpp"
#include "mjcf/propose/proposals.hpp"

namespace legwright {

/// A robot that was built of modules.
struct BuiltRobot {
  std::string xml;           // MJCF with keyframe `home` and declared design parameters
  ProposedParameters found;  // as read back, with what was declared
  std::string pose;          // in words, where one was searched for
  // Modules that stand inside each other; what was not known of a servo and what holds instead.
  std::vector<std::string> notes;
  std::vector<ModuleOverlap> overlaps;  // those of the first notes
};

/// Builds the robot of an assembly: its body, a home pose in which it stands, and the design
/// parameters that `legwright init` would propose: lengths of links, axes, length and width of the
/// trunk, with which hips move. The vectors are the home pose where the robot stands so; where its
/// legs are drawn stretched out, one is searched for (find_standing_pose()).
/// The same assembly gives the same bytes. Throws InputError where the robot cannot be read back:
/// a limb that is no leg, legs that do not stand.
/// @param file where the robot will be, for messages
BuiltRobot build_robot(const Assembly& assembly, const std::filesystem::path& file);

}  // namespace legwright
