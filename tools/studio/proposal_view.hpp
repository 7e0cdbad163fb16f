// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "tools/adopt/studied_robot.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// What `legwright init` finds of a robot: {words, ahead, told, limbs, parameters with reasons and
/// bounds, left_out}.
Json proposal_json(const StudiedRobot& robot);

/// The robot with the proposals of these names declared in its text, which is not written. Throws
/// InputError for a name that is not proposed, and for a robot that would fall at once.
RobotModel with_proposals(const StudiedRobot& robot, const std::vector<std::string>& names);

/// Files of a robot that were sent: written into a folder. Throws InputError for names that lead
/// out of it, and where none of them is a robot or a task file.
/// @param files [{name, base64}] @return the one to open
std::filesystem::path write_sent_files(const std::filesystem::path& folder, const Json& files);

}  // namespace legwright
