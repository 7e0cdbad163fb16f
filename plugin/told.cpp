// SPDX-License-Identifier: Apache-2.0
#include "plugin/told.hpp"

#include <cstddef>
#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace legwright {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Each number, with its sign, point and exponent, becomes one '#'.
std::string without_numbers(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    if (text[end] == '-' && end + 1 < text.size() && is_digit(text[end + 1])) ++end;
    if (!is_digit(text[end])) {
      out += text[i++];
      continue;
    }
    const auto skip_digits = [&] {
      while (end < text.size() && is_digit(text[end])) ++end;
    };
    skip_digits();
    if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) {
      ++end;
      skip_digits();
    }
    if (end + 2 < text.size() && text[end] == 'e' &&
        (text[end + 1] == '-' || text[end + 1] == '+') && is_digit(text[end + 2])) {
      end += 2;
      skip_digits();
    }
    out += '#';
    i = end;
  }
  return out;
}

}  // namespace

bool first_told(std::string_view subject, std::string_view reason) noexcept {
  try {
    static std::mutex mutex;
    static std::set<std::size_t> told;
    constexpr std::size_t kMost = 1000;
    const std::string text = std::string(subject) + '\n' + without_numbers(reason);
    const std::lock_guard lock(mutex);
    return told.size() < kMost && told.insert(std::hash<std::string>()(text)).second;
  } catch (...) {
    return false;  // no memory to remember it by
  }
}

}  // namespace legwright
