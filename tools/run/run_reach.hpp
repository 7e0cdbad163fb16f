// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// Looks at every robot and scene of a run that somebody else may have made. Throws InputError
/// where one names a file out of reach, or is refused as a robot's files are; and at a symbolic
/// link, which no run has.
void check_reach(const std::filesystem::path& run, const FileReach& reach);

}  // namespace legwright
