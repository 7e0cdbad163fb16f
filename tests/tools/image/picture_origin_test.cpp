// SPDX-License-Identifier: Apache-2.0
#include "tools/image/picture_origin.hpp"

#include <gtest/gtest.h>

#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"
#include "tools/image/webp.hpp"

namespace legwright {
namespace {

const std::string kOrigin = R"({"result/a&<b>.xml":"0f"})";
const Image kPicture(16, 12, {200, 120, 40});

std::filesystem::path written(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  const auto file = std::filesystem::path(testing::TempDir()) / name;
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return file;
}

TEST(PictureOrigin, IsCarriedByAPngThatShowsTheSame) {
  const auto bytes = encode_png(kPicture, kOrigin);
  EXPECT_EQ(bytes, encode_png(kPicture, kOrigin));
  EXPECT_EQ(decode_png(bytes), kPicture);
  EXPECT_EQ(picture_origin(written("origin.png", bytes)), kOrigin);
  EXPECT_EQ(picture_origin(written("origin.png", encode_png(kPicture))), "");
}

TEST(PictureOrigin, IsCarriedByAWebpThatShowsTheSame) {
  const Animation animation{{kPicture, Image(16, 12, {10, 20, 30})}, {50, 100}};
  const auto bytes = encode_webp(animation, 80, kOrigin), plain = encode_webp(animation, 80);
  EXPECT_EQ(bytes, encode_webp(animation, 80, kOrigin));
  EXPECT_EQ(decode_webp(bytes).frames, decode_webp(plain).frames);
  EXPECT_EQ(decode_webp(bytes).end_ms, animation.end_ms);
  EXPECT_EQ(picture_origin(written("origin.webp", bytes)), kOrigin);
  EXPECT_EQ(picture_origin(written("origin.webp", plain)), "");
  const Animation one{{kPicture}, {100}};
  EXPECT_EQ(webp_origin(encode_webp(one, 70, kOrigin)), kOrigin);
  EXPECT_EQ(decode_webp(encode_webp(one, 70, kOrigin)).frames.size(), 1U);
}

TEST(PictureOrigin, IsWholeOrMissingInWhatIsCutOffAndInNoPicture) {
  for (auto bytes : {encode_png(kPicture, kOrigin), encode_webp({{kPicture}, {50}}, 80, kOrigin)})
    while (!bytes.empty()) {
      bytes.pop_back();
      const std::string origin = picture_origin(written("cut", bytes));
      EXPECT_TRUE(origin.empty() || origin == kOrigin) << bytes.size();
    }
  EXPECT_EQ(png_origin(std::vector<std::uint8_t>(40, 0xff)), "");
}

}  // namespace
}  // namespace legwright
