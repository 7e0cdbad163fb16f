// SPDX-License-Identifier: Apache-2.0
#include "tools/image/id_image.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/image/png.hpp"

namespace legwright {
namespace {

IdImage stripes() {
  IdImage image(64, 9);
  for (std::size_t i = 0; i < image.id.size(); ++i) image.id[i] = static_cast<std::uint16_t>(i / 3);
  return image;
}

TEST(IdImage, ComesBackFromItsPngWithEveryNumber) {
  const test::TemporaryFolder folder;
  const IdImage image = stripes();
  write_id_png(folder.path() / "a.png", image);
  EXPECT_EQ(read_id_png(folder.path() / "a.png"), image);
  EXPECT_EQ(read_png(folder.path() / "a.png"), in_colours(image));  // what people see of it
  IdImage tall(2, 2);
  tall.id[3] = 256;
  EXPECT_THROW(write_id_png(folder.path() / "b.png", tall), std::invalid_argument);
  write_png(folder.path() / "c.png", Image(4, 4));
  EXPECT_THROW(read_id_png(folder.path() / "c.png"), std::runtime_error);
  EXPECT_THROW(read_id_png(folder.path() / "absent.png"), std::runtime_error);
}

TEST(IdImage, NeighboursHaveColoursOfTheirOwn) {
  IdImage all(255, 1);
  for (std::size_t i = 0; i < all.id.size(); ++i) all.id[i] = static_cast<std::uint16_t>(i);
  const Image colours = in_colours(all);
  std::set<Rgb> seen;
  for (int x = 0; x < 60; ++x)
    seen.insert({colours.pixel(x, 0)[0], colours.pixel(x, 0)[1], colours.pixel(x, 0)[2]});
  EXPECT_EQ(seen.size(), 60U);
}

TEST(DifferentPixels, AreCountedInIdsAndInColours) {
  IdImage a = stripes(), b = a;
  EXPECT_EQ(different_pixels(a, b), 0);
  b.id[7] ^= 1;
  b.id[100] ^= 8;
  EXPECT_EQ(different_pixels(a, b), 2);
  Image c(5, 5), d(5, 5);
  d.pixel(2, 2)[0] ^= 1;
  d.pixel(2, 2)[2] ^= 1;
  EXPECT_EQ(different_pixels(c, d), 1);
  EXPECT_THROW(different_pixels(a, IdImage(1, 1)), std::invalid_argument);
  EXPECT_THROW(different_pixels(c, Image(5, 4)), std::invalid_argument);
}

}  // namespace
}  // namespace legwright
