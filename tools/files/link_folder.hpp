// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace legwright {

/// Gives each file of a folder a second name in an empty one, which is to take its place, and that
/// the first one's owner and mode. write_file() then takes a name away, not the bytes behind it.
/// @return false where that cannot be: a file system without second names, a mounted one, files or
/// folders of others, access lists. Throws std::filesystem::filesystem_error where the disk fails.
bool link_folder(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace legwright
