// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/image/image.hpp"

namespace legwright {

/// Which geom is seen at each pixel, rows from the top: 0 where there is none, else its number in
/// the model plus 1.
struct IdImage {
  int width = 0, height = 0;  // [pixels]
  std::vector<std::uint16_t> id;

  IdImage() = default;
  IdImage(int w, int h)
      : width(w), height(h), id(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  bool operator==(const IdImage&) const = default;
};

/// Pixels that show another geom. Throws std::invalid_argument for pictures of different sizes.
int different_pixels(const IdImage& a, const IdImage& b);
/// Pixels whose colour is not the same to the byte; throws as above.
int different_pixels(const Image& a, const Image& b);

/// Each geom in a colour of its own, for people; background is white.
Image in_colours(const IdImage& image);

/// As a PNG with a palette: the numbers are exact, and it can be looked at. Throws
/// std::invalid_argument for numbers above 255.
void write_id_png(const std::filesystem::path& file, const IdImage& image);
/// Reads what write_id_png wrote. Throws std::system_error where the file cannot be read,
/// std::runtime_error where it is no such PNG.
IdImage read_id_png(const std::filesystem::path& file);

}  // namespace legwright
