// SPDX-License-Identifier: Apache-2.0
#include "tools/image/image.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <system_error>

#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"

namespace legwright {
namespace {

Image colourful(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i * 37 + i / 7);
  return image;
}

TEST(Png, ComesBackAsWritten) {
  const Image image = colourful(37, 23);
  const auto bytes = encode_png(image);
  EXPECT_EQ(decode_png(bytes), image);
  EXPECT_EQ(encode_png(image), bytes);
  Image other = image;
  other.pixel(5, 5)[1] ^= 1;
  EXPECT_NE(encode_png(other), bytes);
}

TEST(Png, FileIsWholeOrAbsent) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "picture.png";
  write_png(file, colourful(8, 8));
  EXPECT_EQ(read_png(file), colourful(8, 8));
  EXPECT_THROW(write_png("/nonexistent/picture.png", colourful(8, 8)), std::system_error);
  EXPECT_THROW(read_png("/nonexistent/picture.png"), std::system_error);
}

TEST(Png, RefusesTornAndForeignBytes) {
  auto bytes = encode_png(colourful(16, 16));
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(decode_png(bytes), std::runtime_error);
  EXPECT_THROW(decode_png({'G', 'I', 'F'}), std::runtime_error);
  EXPECT_THROW(decode_png({}), std::runtime_error);
}

TEST(Image, PasteCutsOffWhatLiesOutside) {
  Image whole(4, 4, {0, 0, 0});
  copy_into(whole, Image(3, 3, {9, 9, 9}), -1, 2);
  EXPECT_EQ(whole.pixel(0, 2)[0], 9);
  EXPECT_EQ(whole.pixel(1, 3)[0], 9);
  EXPECT_EQ(whole.pixel(2, 2)[0], 0);
  EXPECT_EQ(whole.pixel(0, 1)[0], 0);
  const Image before = whole;
  copy_into(whole, Image(3, 3), 10, 10);
  EXPECT_EQ(whole, before);
}

TEST(Image, ShrinkTakesMeans) {
  Image image(4, 2, {0, 0, 0});
  image.pixel(0, 0)[0] = 200;
  const Image small = downsample(image, 2);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 1);
  EXPECT_EQ(small.pixel(0, 0)[0], 50);
  EXPECT_EQ(small.pixel(1, 0)[0], 0);
}

TEST(Image, StampBlendsByCover) {
  Image image(2, 1, {0, 0, 0});
  stamp(image, {2, 1, {255, 51}}, 0, 0, {100, 100, 100});
  EXPECT_EQ(image.pixel(0, 0)[0], 100);
  EXPECT_EQ(image.pixel(1, 0)[0], 20);
  stamp(image, {2, 1, {255, 255}}, 5, 5, {1, 1, 1});  // outside: nothing
  EXPECT_EQ(image.pixel(1, 0)[0], 20);
}

TEST(Image, DotIsRoundAndRingIsHollow) {
  Image image(21, 21);
  draw_dot(image, 10.5, 10.5, 8.0, {0, 0, 0});
  EXPECT_EQ(image.pixel(10, 10)[0], 0);
  EXPECT_EQ(image.pixel(3, 3)[0], 255);
  Image ring(21, 21);
  draw_dot(ring, 10.5, 10.5, 8.0, {0, 0, 0}, 2.0);
  EXPECT_EQ(ring.pixel(10, 10)[0], 255);
  EXPECT_EQ(ring.pixel(10, 3)[0], 0);
}

}  // namespace
}  // namespace legwright
