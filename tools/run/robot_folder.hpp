// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "mjcf/text/robot_files.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {

/// Writes a robot into an existing folder: the main file as robot.xml, the files that it includes
/// and its assets below, gathered (RobotFiles::gathered()). Assets that nobody changes
/// (AssetFile::may_link) become hard links, where the file system has them, and take no space.
/// Throws std::system_error where the disk fails, InputError for an asset that is no longer there.
void write_robot_files(const std::filesystem::path& folder, const RobotFiles& files,
                       Durability durability = Durability::power);

/// Writes a robot's main file to another place. In the folder of the robot that file alone: what it
/// names is found from there. Elsewhere the robot as a whole, gathered. Throws IoError, before
/// anything is written, where one of the other files would replace one or go through a link.
void write_main_file(const std::filesystem::path& output, const RobotFiles& files);

/// Copies the folder of a design of this robot, as fs::copy does, but links what
/// write_robot_files() would link. Throws std::system_error where the disk fails or `to` exists.
void copy_design(const std::filesystem::path& from, const std::filesystem::path& to,
                 const RobotFiles& files);

}  // namespace legwright
