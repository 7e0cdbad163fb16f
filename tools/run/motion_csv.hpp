// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "plugin/trajectory.hpp"

namespace legwright {

/// The plan of a motion.csv; travel and turn of a cycle are the last row minus the first.
/// Throws InputError for anything else, std::system_error if unreadable.
Trajectory read_motion_csv(const std::filesystem::path& file);

}  // namespace legwright
