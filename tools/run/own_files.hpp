// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace legwright {

/// Whether the program writes files of this name into runs.
bool is_name_of_runs(const std::string& name);

/// The files in the folder of a run that are none of it: somebody put them there, and nothing may
/// remove them. Paths below the folder, sorted; of a folder of them only itself. Where the robot's
/// files cannot be told (inputs/ are damaged), only what lies beside the parts of a run is named.
std::vector<std::string> own_files_in(const std::filesystem::path& run);

}  // namespace legwright
