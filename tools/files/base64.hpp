// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// RFC 4648, with padding.
std::string base64_of(std::string_view bytes);
/// The bytes of numbers, one after the other, as they are in memory.
template <class Number>
std::string base64_of(const std::vector<Number>& numbers) {
  return base64_of(std::string_view(reinterpret_cast<const char*>(numbers.data()),
                                    sizeof(Number) * numbers.size()));
}
/// The bytes that such a text stands for, or nothing where it is none.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace legwright
