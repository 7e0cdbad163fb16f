// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tools/files/json_file.hpp"

namespace legwright {

/// What `legwright validate` says of a run, or of each task of a joint one: {verdict, lines}, each
/// line with the moment at which it happened, where that is known. The word is PASS, FAIL, or
/// UNKNOWN where a verdict is of another result, which then has no lines.
Json verdict_lines(const std::filesystem::path& run);

}  // namespace legwright
