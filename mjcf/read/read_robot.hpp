// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Reads a plain MJCF: understood by compiling it with MuJoCo, parameters from its <custom>
/// section. Throws InputError for anything wrong with the file or a file that is not there,
/// std::system_error where it cannot be read. @param reach of the files that it names
RobotModel read_robot(const std::filesystem::path& file, const FileReach& reach = {});
/// The same from text that has not been written yet; `file` is for messages, and its folder is
/// where other files that the text names are looked for.
/// @param known of another design of the same robot, whose legs and feet are looked for again;
///        null: they are found in the home pose.
RobotModel parse_robot(const std::string& xml, const std::filesystem::path& file,
                       const Structure* known = nullptr);
RobotModel parse_robot(const RobotFiles& files, const Structure* known = nullptr);

/// The same robot with its files as copies have them (RobotFiles::gathered()).
void gather(RobotModel& robot);

}  // namespace legwright
