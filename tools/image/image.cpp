// SPDX-License-Identifier: Apache-2.0
#include "tools/image/image.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

void blend(std::uint8_t* pixel, Rgb colour, double cover) {
  for (int c = 0; c < 3; ++c) {
    const double mixed = pixel[c] + (static_cast<double>(colour[c]) - pixel[c]) * cover;
    pixel[c] = static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0, 255.0)));
  }
}

}  // namespace

Image::Image(int w, int h, Rgb colour)
    : width(w), height(h), rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = colour[i % 3];
}

void copy_into(Image& whole, const Image& part, int x, int y) {
  const int left = std::max(0, -x), right = std::min(part.width, whole.width - x);
  if (left >= right) return;
  for (int row = std::max(0, -y); row < std::min(part.height, whole.height - y); ++row) {
    std::copy_n(part.pixel(left, row), 3 * (right - left), whole.pixel(x + left, y + row));
  }
}

void stamp(Image& whole, const Mask& mask, int x, int y, Rgb colour) {
  for (int row = std::max(0, -y); row < std::min(mask.height, whole.height - y); ++row) {
    for (int column = std::max(0, -x); column < std::min(mask.width, whole.width - x); ++column) {
      const auto cover = mask.cover[static_cast<std::size_t>(row) * mask.width + column];
      blend(whole.pixel(x + column, y + row), colour, cover / 255.0);
    }
  }
}

void fill(Image& whole, int x, int y, int width, int height, Rgb colour) {
  for (int row = std::max(0, y); row < std::min(y + height, whole.height); ++row) {
    for (int column = std::max(0, x); column < std::min(x + width, whole.width); ++column) {
      std::copy(colour.begin(), colour.end(), whole.pixel(column, row));
    }
  }
}

void draw_dot(Image& whole, double x, double y, double radius, Rgb colour, double ring) {
  const int low_y = std::max(0, static_cast<int>(y - radius) - 1);
  const int high_y = std::min(whole.height - 1, static_cast<int>(y + radius) + 1);
  const int low_x = std::max(0, static_cast<int>(x - radius) - 1);
  const int high_x = std::min(whole.width - 1, static_cast<int>(x + radius) + 1);
  for (int row = low_y; row <= high_y; ++row) {
    for (int column = low_x; column <= high_x; ++column) {
      const double distance = std::hypot(column + 0.5 - x, row + 0.5 - y);
      double cover = std::clamp(radius - distance + 0.5, 0.0, 1.0);
      if (ring > 0.0) cover *= std::clamp(distance - (radius - ring) + 0.5, 0.0, 1.0);
      if (cover > 0.0) blend(whole.pixel(column, row), colour, cover);
    }
  }
}

void fade(Image& image, double share) {
  for (auto& part : image.rgb)
    part = static_cast<std::uint8_t>(std::lround(part + (255.0 - part) * share));
}

Image downsample(const Image& image, int factor) {
  Image small(image.width / factor, image.height / factor);
  const int count = factor * factor;
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      int sum[3] = {count / 2, count / 2, count / 2};
      for (int k = 0; k < count; ++k) {
        const std::uint8_t* pixel = image.pixel(factor * x + k % factor, factor * y + k / factor);
        for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
      }
      for (int c = 0; c < 3; ++c) small.pixel(x, y)[c] = static_cast<std::uint8_t>(sum[c] / count);
    }
  }
  return small;
}

}  // namespace legwright
