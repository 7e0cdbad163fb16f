// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace legwright {

/// What to do with a robot that MuJoCo puts together itself: the command, for a shell, by which
/// MuJoCo writes it out as one file beside the robot's, FILE_flat.xml.
std::string written_out_cure(const std::filesystem::path& file);

}  // namespace legwright
