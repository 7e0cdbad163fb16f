// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/image/image.hpp"

namespace legwright {

/// The picture as the bytes of a PNG file; the same picture gives the same bytes.
std::vector<std::uint8_t> encode_png(const Image& image);
/// A PNG file's bytes as a picture; throws std::runtime_error where they are none.
Image decode_png(const std::vector<std::uint8_t>& bytes);

/// Writes a PNG so that the file is either there whole or not at all. Throws std::system_error.
void write_png(const std::filesystem::path& file, const Image& image);
/// Reads a PNG. Throws std::system_error where the file cannot be read, std::runtime_error where it
/// is no PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace legwright
