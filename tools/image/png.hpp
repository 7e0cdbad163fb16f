// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/image/image.hpp"

namespace legwright {

/// The picture as the bytes of a PNG file; the same picture gives the same bytes.
/// @param origin a text that the file carries, which no picture shows; see png_origin()
std::vector<std::uint8_t> encode_png(const Image& image, const std::string& origin = {});
/// The text that a PNG file carries; empty where it has none, or is no PNG.
std::string png_origin(const std::vector<std::uint8_t>& bytes);
/// A PNG file's bytes as a picture; throws std::runtime_error where they are none.
Image decode_png(const std::vector<std::uint8_t>& bytes);

/// Writes a PNG so that the file is either there whole or not at all. Throws std::system_error.
void write_png(const std::filesystem::path& file, const Image& image,
               const std::string& origin = {});
/// Reads a PNG. Throws std::system_error where the file cannot be read, std::runtime_error where it
/// is no PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace legwright
