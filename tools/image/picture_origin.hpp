// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace legwright {

/// The text that a PNG or WebP file carries of what it shows; empty where there is none. Throws
/// std::system_error where the file cannot be read.
std::string picture_origin(const std::filesystem::path& file);

}  // namespace legwright
