// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "mjcf/propose/facing.hpp"
#include "mjcf/propose/proposal.hpp"
#include "mjcf/read/limbs.hpp"
#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// A robot that was studied: what it is, what a designer may change, and what was left out.
struct ProposedParameters {
  RobotModel model;
  Facing facing;
  std::vector<Limb> limbs;            // as it faces
  std::vector<Proposal> proposals;    // each and all of them together are accepted by parse_robot
  std::vector<std::string> left_out;  // "front_thigh_length: why", one each
  std::vector<std::string> remarks;   // what may be a mistake in the file
  std::string not_standing;           // why the home pose is none to walk from; empty where it is
  std::set<std::string> unnamed;      // joints of links that lack but a name of their body
};

/// Reads a robot and proposes its design parameters: length of each link of a leg, left and right
/// tied; direction of each joint's axis, left and right mirrored; length and width of the trunk;
/// attachment of linear actuators. A parameter that the file's construction does not allow is left
/// out, with the reason. What the file declares already is kept, and nothing of that name proposed.
/// Throws InputError as parse_robot() does.
ProposedParameters propose_parameters(const std::string& xml, const std::filesystem::path& file,
                                      const Forward& forward = {});

}  // namespace legwright
