// SPDX-License-Identifier: Apache-2.0
#include "tools/image/side_by_side.hpp"

#include <algorithm>

namespace legwright {
namespace {

constexpr int kBetween = 8;  // pictures [pixels]
constexpr Rgb kDiffers{255, 0, 0};
constexpr Rgb kNoPicture{128, 128, 128};

/// One beside the other from the same top edge; what neither covers is grey.
Image of_other_sizes(const Image& before, const Image& after) {
  Image all(before.width + kBetween + after.width, std::max(before.height, after.height),
            kNoPicture);
  copy_into(all, before, 0, 0);
  copy_into(all, after, before.width + kBetween, 0);
  return all;
}

}  // namespace

Image side_by_side(const Image& before, const Image& after) {
  if (before.width != after.width || before.height != after.height)
    return of_other_sizes(before, after);
  Image difference = after;
  fade(difference, 0.75);
  for (int y = 0; y < after.height; ++y) {
    for (int x = 0; x < after.width; ++x) {
      if (!std::equal(before.pixel(x, y), before.pixel(x, y) + 3, after.pixel(x, y)))
        std::copy(kDiffers.begin(), kDiffers.end(), difference.pixel(x, y));
    }
  }
  Image all(3 * after.width + 2 * kBetween, after.height);
  copy_into(all, before, 0, 0);
  copy_into(all, after, after.width + kBetween, 0);
  copy_into(all, difference, 2 * (after.width + kBetween), 0);
  return all;
}

}  // namespace legwright
