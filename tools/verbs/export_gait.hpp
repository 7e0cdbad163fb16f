// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace legwright {

/// Writes the gaits of a run for stock MuJoCo and for drivers of real robots: walk.xml (the scene
/// of the gait without the plugin), gait.csv (one cycle, as the plugin plays it), gains.json
/// (servos, period, travel), each with TASK_ before its name where there are several tasks, and
/// play.py, which plays them. Throws IoError where one of the robot's own files has such a name,
/// MujocoError for a scene that cannot be played. @return the tasks; one empty name for a run of
/// one
std::vector<std::string> write_gaits(const std::filesystem::path& run,
                                     const std::filesystem::path& folder);

}  // namespace legwright
