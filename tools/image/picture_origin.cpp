// SPDX-License-Identifier: Apache-2.0
#include "tools/image/picture_origin.hpp"

#include <cstdint>
#include <vector>

#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"
#include "tools/image/webp.hpp"

namespace legwright {

std::string picture_origin(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return text.starts_with("RIFF") ? webp_origin(bytes) : png_origin(bytes);
}

}  // namespace legwright
