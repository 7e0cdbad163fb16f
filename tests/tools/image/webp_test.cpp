// SPDX-License-Identifier: Apache-2.0
#include "tools/image/webp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

/// A dark square that moves over noise that stays.
Animation moving_square(int count) {
  Animation animation;
  for (int k = 0; k < count; ++k) {
    Image frame(64, 48);
    for (std::size_t i = 0; i < frame.rgb.size(); ++i)
      frame.rgb[i] = static_cast<std::uint8_t>(128 + (i * 2654435761U >> 8) % 97);
    fill(frame, 4 + 8 * k, 20, 8, 8, {20, 20, 20});
    animation.frames.push_back(frame);
    animation.end_ms.push_back(50 * (k + 1));
  }
  return animation;
}

TEST(Webp, KeepsFramesTimesAndBytes) {
  const Animation animation = moving_square(6);
  const auto bytes = encode_webp(animation, 80);
  EXPECT_EQ(encode_webp(animation, 80), bytes);
  const Animation back = decode_webp(bytes);
  ASSERT_EQ(back.frames.size(), 6U);
  EXPECT_EQ(back.end_ms, animation.end_ms);
  for (std::size_t k = 0; k < 6; ++k) {
    const Image &was = animation.frames[k], &is = back.frames[k];
    ASSERT_EQ(is.width, 64);
    ASSERT_EQ(is.height, 48);
    double sum = 0.0;
    for (std::size_t i = 0; i < was.rgb.size(); ++i) sum += std::abs(was.rgb[i] - is.rgb[i]);
    EXPECT_LT(sum / static_cast<double>(was.rgb.size()), 25.0) << k;
    EXPECT_LT(is.pixel(8 + 8 * static_cast<int>(k), 24)[0], 90) << k;  // the square where it was
  }
}

TEST(Webp, KeepsToASizeByLessQuality) {
  const Animation animation = moving_square(6);
  const std::size_t large = encode_webp(animation, 80).size(),
                    small = encode_webp(animation, 10).size();
  ASSERT_LT(small, large);
  EXPECT_EQ(encode_webp_within(animation, large).size(), large);
  EXPECT_LT(encode_webp_within(animation, large - 1).size(), large);
  EXPECT_EQ(encode_webp_within(animation, 1).size(), small);  // better than none
}

TEST(Webp, RefusesWhatIsNoAnimation) {
  EXPECT_THROW(encode_webp({}, 80), std::invalid_argument);
  Animation animation = moving_square(3);
  animation.end_ms[2] = animation.end_ms[1];
  EXPECT_THROW(encode_webp(animation, 80), std::invalid_argument);
  animation = moving_square(3);
  animation.frames[1] = Image(8, 8);
  EXPECT_THROW(encode_webp(animation, 80), std::invalid_argument);
  EXPECT_THROW(decode_webp({}), std::runtime_error);
  EXPECT_THROW(decode_webp({'R', 'I', 'F', 'F'}), std::runtime_error);
}

}  // namespace
}  // namespace legwright
