// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// A name for the main file that none of the robot's other files has.
std::string free_name(std::string name, const RobotFiles& files);

/// The robot's files as they are, gathered, the main one under `name`. Throws InputError where one
/// of them has a name that is needed. @return all but the main one
std::vector<std::string> write_robot(const RobotFiles& files, const std::filesystem::path& folder,
                                     const std::string& name);

}  // namespace legwright
