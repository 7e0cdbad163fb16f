// SPDX-License-Identifier: Apache-2.0
#include "tools/image/webp.hpp"

#include <webp/demux.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

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

// A text is what XMP calls the source of a picture (Dublin Core's dc:source).
constexpr std::string_view kBeforeOrigin =
    R"(<x:xmpmeta xmlns:x="adobe:ns:meta/">)"
    R"(<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">)"
    R"(<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:source>)";
constexpr std::string_view kAfterOrigin = "</dc:source></rdf:Description></rdf:RDF></x:xmpmeta>";
constexpr std::pair<char, std::string_view> kEscapes[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto* const found = std::find_if(std::begin(kEscapes), std::end(kEscapes),
                                           [&](const auto& escape) { return escape.first == c; });
    if (found == std::end(kEscapes))
      out += c;
    else
      out += found->second;
  }
  return out;
}

std::string unescaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto* const found =
        std::find_if(std::begin(kEscapes), std::end(kEscapes),
                     [&](const auto& escape) { return text.starts_with(escape.second); });
    out += found == std::end(kEscapes) ? text.front() : found->first;
    text.remove_prefix(found == std::end(kEscapes) ? 1 : found->second.size());
  }
  return out;
}

using Mux = std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)>;

/// The file with a text in it.
std::vector<std::uint8_t> with_origin(const WebPData& file, const std::string& origin) {
  const std::string packet =
      std::string(kBeforeOrigin) + escaped(origin) + std::string(kAfterOrigin);
  const WebPData chunk{reinterpret_cast<const std::uint8_t*>(packet.data()), packet.size()};
  const Mux mux(WebPMuxCreate(&file, 0), WebPMuxDelete);
  WebPData out;
  WebPDataInit(&out);
  if (!mux || WebPMuxSetChunk(mux.get(), "XMP ", &chunk, 0) != WEBP_MUX_OK ||
      WebPMuxAssemble(mux.get(), &out) != WEBP_MUX_OK)
    throw std::runtime_error("WebP: its text cannot be written");
  std::vector<std::uint8_t> bytes(out.bytes, out.bytes + out.size);
  WebPDataClear(&out);
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> encode_webp(const Animation& animation, float quality,
                                      const std::string& origin) {
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
  const std::unique_ptr<WebPData, decltype(&WebPDataClear)> owned(&data, WebPDataClear);
  if (!origin.empty()) return with_origin(data, origin);
  return {data.bytes, data.bytes + data.size};
}

std::string webp_origin(const std::vector<std::uint8_t>& bytes) {
  const WebPData file{bytes.data(), bytes.size()};
  const Mux mux(WebPMuxCreate(&file, 0), WebPMuxDelete);
  WebPData chunk;
  if (!mux || WebPMuxGetChunk(mux.get(), "XMP ", &chunk) != WEBP_MUX_OK) return {};
  const std::string_view packet(reinterpret_cast<const char*>(chunk.bytes), chunk.size);
  if (!packet.starts_with(kBeforeOrigin) || !packet.ends_with(kAfterOrigin)) return {};
  return unescaped(packet.substr(kBeforeOrigin.size(),
                                 packet.size() - kBeforeOrigin.size() - kAfterOrigin.size()));
}

std::vector<std::uint8_t> encode_webp_within(const Animation& animation, std::size_t most_bytes,
                                             const std::string& origin) {
  std::vector<std::uint8_t> bytes;
  for (const float quality : {80.0F, 65.0F, 50.0F, 30.0F, 10.0F}) {
    bytes = encode_webp(animation, quality, origin);
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
