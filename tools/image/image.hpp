// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace legwright {

/// A colour of an Image.
using Rgb = std::array<std::uint8_t, 3>;

/// A picture: rows from the top, three bytes per pixel.
struct Image {
  int width = 0, height = 0;  // [pixels]
  std::vector<std::uint8_t> rgb;

  Image() = default;
  Image(int w, int h, Rgb colour = {255, 255, 255});

  std::uint8_t* pixel(int x, int y) { return &rgb[3 * (static_cast<std::size_t>(y) * width + x)]; }
  const std::uint8_t* pixel(int x, int y) const {
    return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
  }
  bool operator==(const Image&) const = default;
};

/// How much of a colour lies on each pixel, 0 … 255: text that is laid over a picture.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> cover;
};

/// Copies `part` into `whole` with its top left corner at (x, y); what lies outside is cut off.
void copy_into(Image& whole, const Image& part, int x, int y);
/// Lays `colour` over the picture where the mask covers it.
void stamp(Image& whole, const Mask& mask, int x, int y, Rgb colour);
/// Fills a rectangle.
void fill(Image& whole, int x, int y, int width, int height, Rgb colour);
/// A round dot with soft edges; `ring` > 0 draws only a ring of that width [pixels].
void draw_dot(Image& whole, double x, double y, double radius, Rgb colour, double ring = 0.0);
/// Blends the whole picture towards white by `share`, 0 … 1.
void fade(Image& image, double share);
/// The picture at 1/factor of its size, each pixel the mean of factor × factor.
Image downsample(const Image& image, int factor);

}  // namespace legwright
