// SPDX-License-Identifier: Apache-2.0
#include "plugin/number_text.hpp"

#include <charconv>
#include <cmath>

namespace legwright {

std::optional<double> read_number(std::string_view token) {
  double value = 0.0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  // Also false for nan, which from_chars accepts.
  if (!(std::abs(value) <= kLargestNumber)) return std::nullopt;
  return value;
}

std::vector<std::string_view> split_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<std::string_view> parts;
  std::size_t begin = text.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = text.find_first_of(kBlanks, begin);
    parts.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kBlanks, end);  // npos stays npos
  }
  return parts;
}

std::string quoted(std::string_view token) {
  constexpr std::size_t kLongest = 40;
  std::string result = "\"";
  for (const char c : token.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte > 0x7e ? '?' : c;
  }
  return result + (token.size() > kLongest ? "…\"" : "\"");
}

}  // namespace legwright
