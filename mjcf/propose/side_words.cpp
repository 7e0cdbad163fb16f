// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/side_words.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace legwright {
namespace {

bool is_side_word(const std::string& word) {
  static const std::set<std::string> words{
      "fl",   "fr",     "hl",  "hr", "rl", "rr",   "lf",    "rf",    "lh",   "rh",
      "lr",   "l",      "r",   "f",  "h",  "left", "right", "front", "hind", "rear",
      "back", "middle", "mid", "lm", "rm", "ml",   "mr",    "fore"};
  return words.count(word) > 0;
}

}  // namespace

std::string without_side(const std::string& name) {
  std::string out, word;
  const auto end_word = [&] {
    std::string low = word;
    std::transform(low.begin(), low.end(), low.begin(), [](unsigned char c) {
      return static_cast<char>(c < 128 ? std::tolower(c) : c);
    });
    while (!low.empty() && low.back() >= '0' && low.back() <= '9') low.pop_back();
    if (!word.empty() && !is_side_word(low) && !low.empty()) out += (out.empty() ? "" : "_") + word;
    word.clear();
  };
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter)
      word += c;
    else
      end_word();
  }
  end_word();
  return out;
}

}  // namespace legwright
