// SPDX-License-Identifier: Apache-2.0
#include "tools/image/id_image.hpp"

#include <lodepng.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

/// Neighbouring numbers get colours far apart: hue by steps of the golden ratio.
Rgb colour_of(unsigned id) {
  if (id == 0) return {255, 255, 255};
  const unsigned turn = (id * 989U) % 1536U;  // 1536 hues around the circle, 989/1536 = 0.644
  const auto rise = static_cast<std::uint8_t>(turn % 256U);
  const auto fall = static_cast<std::uint8_t>(255U - rise);
  constexpr std::uint8_t kNone = 0, kAll = 255;
  const Rgb hues[] = {{kAll, rise, kNone}, {fall, kAll, kNone}, {kNone, kAll, rise},
                      {kNone, fall, kAll}, {rise, kNone, kAll}, {kAll, kNone, fall}};
  Rgb colour = hues[turn / 256U];
  for (auto& part : colour) part = static_cast<std::uint8_t>(30 + part * 200 / 255);
  return colour;
}

template <class Picture>
void check_sizes(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("pictures of different sizes cannot be compared");
}

std::runtime_error png_error(unsigned error) {
  return std::runtime_error(std::string("PNG: ") + lodepng_error_text(error));
}

void set_palette(LodePNGColorMode& mode) {
  mode.colortype = LCT_PALETTE;
  mode.bitdepth = 8;
  for (unsigned id = 0; id < 256; ++id) {
    const Rgb c = colour_of(id);
    lodepng_palette_add(&mode, c[0], c[1], c[2], 255);
  }
}

}  // namespace

int different_pixels(const IdImage& a, const IdImage& b) {
  check_sizes(a, b);
  int count = 0;
  for (std::size_t i = 0; i < a.id.size(); ++i) count += a.id[i] != b.id[i];
  return count;
}

int different_pixels(const Image& a, const Image& b) {
  check_sizes(a, b);
  int count = 0;
  for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
    count += a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
  }
  return count;
}

Image in_colours(const IdImage& image) {
  Image coloured(image.width, image.height);
  for (std::size_t i = 0; i < image.id.size(); ++i) {
    const Rgb colour = colour_of(image.id[i]);
    for (std::size_t c = 0; c < 3; ++c) coloured.rgb[3 * i + c] = colour[c];
  }
  return coloured;
}

void write_id_png(const std::filesystem::path& file, const IdImage& image) {
  std::vector<std::uint8_t> indices;
  for (const std::uint16_t id : image.id) {
    if (id > 255) throw std::invalid_argument("more than 255 geoms do not fit into a palette");
    indices.push_back(static_cast<std::uint8_t>(id));
  }
  lodepng::State state;
  state.encoder.auto_convert = 0;  // it would order the palette anew
  set_palette(state.info_raw);
  set_palette(state.info_png.color);
  std::vector<std::uint8_t> bytes;
  const unsigned error = lodepng::encode(bytes, indices, static_cast<unsigned>(image.width),
                                         static_cast<unsigned>(image.height), state);
  if (error != 0) throw png_error(error);
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

IdImage read_id_png(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  lodepng::State state;
  state.decoder.color_convert = 0;  // the indices themselves
  std::vector<std::uint8_t> indices;
  unsigned width = 0, height = 0;
  const unsigned error = lodepng::decode(indices, width, height, state, bytes);
  if (error != 0) throw png_error(error);
  if (state.info_raw.colortype != LCT_PALETTE || state.info_raw.bitdepth != 8)
    throw std::runtime_error(file.string() + ": a PNG, but not one of geoms' numbers");
  IdImage image(static_cast<int>(width), static_cast<int>(height));
  std::copy(indices.begin(), indices.end(), image.id.begin());
  return image;
}

}  // namespace legwright
