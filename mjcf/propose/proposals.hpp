// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/limbs.hpp"
#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// A design parameter that a robot could declare: the pair <numeric>, <text> of its <custom>
/// section.
struct Proposal {
  std::string name;
  double value = 0.0, lower = 0.0, upper = 0.0;
  std::string unit, binding, sentence;
};

/// A robot that was studied: what it is, what a designer may change, and what was left out.
struct ProposedParameters {
  RobotModel model;
  std::vector<Limb> limbs;
  std::vector<Proposal> proposals;    // each and all of them together are accepted by parse_robot
  std::vector<std::string> left_out;  // "front_thigh_length: why", one each
  std::string not_standing;           // why the home pose is none to walk from; empty where it is
};

/// Reads a robot and proposes its design parameters: length of each link of a leg, left and right
/// tied; direction of each joint's axis, left and right mirrored; length and width of the trunk;
/// attachment of linear actuators. A parameter that the file's construction does not allow is left
/// out, with the reason. What the file declares already is kept, and nothing of that name proposed.
/// Throws InputError as parse_robot() does.
ProposedParameters propose_parameters(const std::string& xml, const std::filesystem::path& file);

/// The text with declarations of `proposals` in its <custom> section, which is made where there is
/// none; every other byte stays, line ends are those of the file. Throws InputError for text that
/// is no MJCF.
std::string with_declarations(const std::string& xml, const std::filesystem::path& file,
                              const std::vector<Proposal>& proposals);

}  // namespace legwright
