// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/image/image.hpp"

namespace legwright {

/// Pictures of one size, one after another.
struct Animation {
  std::vector<Image> frames;
  std::vector<int> end_ms;  // when each frame ends, rising [ms]
};

/// The animation as the bytes of a WebP file that loops for ever; the same frames give the same
/// bytes. Throws std::invalid_argument for frames that do not fit together, std::runtime_error
/// where the encoder fails.
/// @param quality 0 … 100
/// @param origin a text that the file carries, which no picture shows; see webp_origin()
std::vector<std::uint8_t> encode_webp(const Animation& animation, float quality,
                                      const std::string& origin = {});

/// As above, with the best quality whose file is at most `most_bytes`, or else the least there is.
std::vector<std::uint8_t> encode_webp_within(const Animation& animation, std::size_t most_bytes,
                                             const std::string& origin = {});

/// The text that a WebP file carries; empty where it has none, or is no WebP.
std::string webp_origin(const std::vector<std::uint8_t>& bytes);

/// Reads it back. Throws std::runtime_error where the bytes are no animated WebP.
Animation decode_webp(const std::vector<std::uint8_t>& bytes);

}  // namespace legwright
