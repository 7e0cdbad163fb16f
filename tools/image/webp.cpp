// SPDX-License-Identifier: Apache-2.0
#include "tools/image/webp.hpp"

#include <webp/demux.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace legwright {
namespace {

using Encoder = std::unique_ptr<WebPAnimEncoder, decltype(&WebPAnimEncoderDelete)>;
using Decoder = std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)>;

/// A frame as the library wants it, freed with its owner.
struct Picture {
  WebPPicture picture{};
  explicit Picture(const Image& image) {
    if (!WebPPictureInit(&picture)) throw std::runtime_error("WebP: another library version");
    picture.use_argb = 1;
    picture.width = image.width;
    picture.height = image.height;
    if (!WebPPictureImportRGB(&picture, image.rgb.data(), 3 * image.width)) throw std::bad_alloc();
  }
  ~Picture() { WebPPictureFree(&picture); }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
};

void check(const Animation& animation) {
  if (animation.frames.empty() || animation.frames.size() != animation.end_ms.size())
    throw std::invalid_argument("an animation needs frames and a time for each");
  int before = 0;
  for (std::size_t i = 0; i < animation.frames.size(); ++i) {
    const Image &first = animation.frames[0], &frame = animation.frames[i];
    if (frame.width != first.width || frame.height != first.height)
      throw std::invalid_argument("the frames of an animation must have one size");
    if (animation.end_ms[i] <= before)
      throw std::invalid_argument("the times of an animation must rise");
    before = animation.end_ms[i];
  }
}

}  // namespace

std::vector<std::uint8_t> encode_webp(const Animation& animation, float quality) {
  check(animation);
  WebPAnimEncoderOptions options;
  WebPConfig config;
  if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&config))
    throw std::runtime_error("WebP: another library version");
  options.anim_params.loop_count = 0;  // for ever
  config.quality = quality;
  config.method = 4;
  config.thread_level = 0;
  const Encoder encoder(
      WebPAnimEncoderNew(animation.frames[0].width, animation.frames[0].height, &options),
      WebPAnimEncoderDelete);
  if (!encoder) throw std::bad_alloc();
  const auto fail = [&] {
    return std::runtime_error(std::string("WebP: ") + WebPAnimEncoderGetError(encoder.get()));
  };
  int start = 0;
  for (std::size_t i = 0; i < animation.frames.size(); ++i) {
    Picture frame(animation.frames[i]);
    if (!WebPAnimEncoderAdd(encoder.get(), &frame.picture, start, &config)) throw fail();
    start = animation.end_ms[i];
  }
  if (!WebPAnimEncoderAdd(encoder.get(), nullptr, start, nullptr)) throw fail();
  WebPData data;
  WebPDataInit(&data);
  if (!WebPAnimEncoderAssemble(encoder.get(), &data)) throw fail();
  std::vector<std::uint8_t> bytes(data.bytes, data.bytes + data.size);
  WebPDataClear(&data);
  return bytes;
}

std::vector<std::uint8_t> encode_webp_within(const Animation& animation, std::size_t most_bytes) {
  std::vector<std::uint8_t> bytes;
  for (const float quality : {80.0F, 65.0F, 50.0F, 30.0F, 10.0F}) {
    bytes = encode_webp(animation, quality);
    if (bytes.size() <= most_bytes) break;
  }
  return bytes;
}

Animation decode_webp(const std::vector<std::uint8_t>& bytes) {
  const WebPData data{bytes.data(), bytes.size()};
  const Decoder decoder(WebPAnimDecoderNew(&data, nullptr), WebPAnimDecoderDelete);
  WebPAnimInfo info;
  if (!decoder || !WebPAnimDecoderGetInfo(decoder.get(), &info))
    throw std::runtime_error("WebP: not an animation");
  Animation animation;
  while (WebPAnimDecoderHasMoreFrames(decoder.get())) {
    std::uint8_t* rgba = nullptr;
    int end = 0;
    if (!WebPAnimDecoderGetNext(decoder.get(), &rgba, &end))
      throw std::runtime_error("WebP: torn in the middle");
    Image frame(static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height));
    for (std::size_t i = 0; i < frame.rgb.size(); ++i) frame.rgb[i] = rgba[i / 3 * 4 + i % 3];
    animation.frames.push_back(std::move(frame));
    animation.end_ms.push_back(end);
  }
  return animation;
}

}  // namespace legwright
