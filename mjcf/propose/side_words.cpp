// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/side_words.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <set>
#include <vector>

namespace legwright {
namespace {

bool is_side_word(const std::string& word) {
  static const std::set<std::string> words{
      "fl",   "fr",     "hl",  "hr", "rl", "rr",   "lf",    "rf",    "lh",   "rh",
      "lr",   "l",      "r",   "f",  "h",  "left", "right", "front", "hind", "rear",
      "back", "middle", "mid", "lm", "rm", "ml",   "mr",    "fore"};
  return words.count(word) > 0;
}

bool is_among(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// A word in small letters, without the number at its end.
std::string plain(const std::string& word) {
  std::string low = word;
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
  while (!low.empty() && low.back() >= '0' && low.back() <= '9') low.pop_back();
  return low;
}

/// What of a name stands between other signs than letters and digits.
std::vector<std::string> words_in(const std::string& name) {
  std::vector<std::string> out(1);
  for (const char c : name) {
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))
      out.back() += c;
    else if (!out.back().empty())
      out.emplace_back();
  }
  if (out.back().empty()) out.pop_back();
  return out;
}

}  // namespace

std::string without_side(const std::string& name) {
  std::string out;
  for (const std::string& word : words_in(name))
    if (const std::string low = plain(word); !low.empty() && !is_side_word(low))
      out += (out.empty() ? "" : "_") + word;
  return out;
}

int row_word(const std::string& name) {
  bool front = false, hind = false;
  for (const std::string& word : words_in(name)) {
    const std::string low = plain(word);
    front = front || is_among(low, {"fl", "fr", "lf", "rf", "front", "fore", "f"});
    hind = hind ||
           is_among(low, {"hl", "hr", "rl", "rr", "lh", "rh", "lr", "hind", "rear", "back", "h"});
  }
  return front - hind;
}

}  // namespace legwright
