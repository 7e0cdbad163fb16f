// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace legwright {

/// What a robot is called in lists and names of folders: its model's name; where that says nothing
/// ("robot", "scene", MuJoCo's own), the name of its file, else of the folder that it is in, or of
/// the run. @param origin what was opened: its MJCF, a task file, an assembly or the folder of a
/// run @param robot its MJCF
std::string robot_label(const std::string& model, const std::filesystem::path& origin,
                        const std::filesystem::path& robot);

}  // namespace legwright
