// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <iterator>
#include <random>
#include <string>

namespace legwright {

/// One to three seeded random edits of a text: bytes changed, cut, doubled, numbers and separators
/// spoilt.
/// @param markup_safe keeps out of the edits what would end or escape an XML attribute.
inline std::string mutate(std::string text, std::mt19937& random, bool markup_safe = false) {
  static const char* const kNasty[] = {"nan",
                                       "inf",
                                       "-inf",
                                       "1e999",
                                       "1e-999",
                                       "0x1F",
                                       "+1",
                                       "1,5",
                                       "1.5.2",
                                       "--1",
                                       ";",
                                       ";;",
                                       "\n",
                                       " ",
                                       "",
                                       "-",
                                       "e5",
                                       "1e308",
                                       "99999999999999999999",
                                       "q:a_rad",
                                       "time_s",
                                       "NaN(7)",
                                       "1d3",
                                       "\t"};
  const auto below = [&random](std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
  };
  const std::size_t edits = 1 + below(3);
  for (std::size_t edit = 0; edit < edits && !text.empty(); ++edit) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(1 + below(40));
    switch (below(8)) {
      case 0:
        text[at] = static_cast<char>(markup_safe ? '(' + below(20) : below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), length));
        break;
      case 4:
        text.resize(at);
        break;
      case 5:
        text[at] = static_cast<char>('0' + below(10));
        break;
      default: {                                                      // a whole word
        const std::size_t begin = text.find_last_of(" ;\n", at) + 1;  // npos + 1 = 0
        const std::size_t end = std::min(text.find_first_of(" ;\n", at), text.size());
        const char* const nasty = kNasty[below(std::size(kNasty))];
        text.replace(begin, end > begin ? end - begin : 0, nasty);
      }
    }
  }
  return text;
}

}  // namespace legwright
