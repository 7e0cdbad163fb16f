// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// How often a part stands in a text, overlaps counted.
inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

}  // namespace legwright
