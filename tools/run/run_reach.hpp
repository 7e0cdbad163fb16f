// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// Looks at every robot and scene of a run that somebody else may have made. Throws InputError
/// where one names a file out of reach, or is refused as a robot's files are; and at a symbolic
/// link, which no run has.
void check_reach(const std::filesystem::path& run, const FileReach& reach);

/// Throws InputError where a symbolic link stands in a run in the place of a folder of results, or
/// of a file that Legwright writes, by its name: through it a file elsewhere would be replaced.
/// Links for other files, as the user's own and a robot's assets, stay.
void check_no_links(const std::filesystem::path& run);

}  // namespace legwright
