// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace legwright {

/// Names under which a model's licence stands beside it: LICENSE, COPYING, NOTICE and their kin.
/// Only regular files of at most 1 MB count: links may lead anywhere.
std::vector<std::string> licences_in(const std::filesystem::path& folder);

/// Copies them, byte for byte. @return their names. Throws std::system_error.
std::vector<std::string> copy_licences(const std::filesystem::path& from,
                                       const std::filesystem::path& to);

}  // namespace legwright
