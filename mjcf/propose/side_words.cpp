// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/side_words.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

namespace legwright {
namespace {

using Words = std::set<std::string>;
const Words kFront{"fl", "fr", "lf", "rf", "front", "fore", "f"};
const Words kHind{"hl", "hr", "rl", "rr",   "bl",   "br",   "lh", "rh",
                  "lr", "lb", "rb", "hind", "rear", "back", "h"};
const Words kOther{"l", "r", "left", "right", "middle", "mid", "lm", "rm", "ml", "mr"};

const char* const kNumbered = "leg";  // with a number it tells which leg, too

bool is_side_word(const std::string& word) {
  return kFront.contains(word) || kHind.contains(word) || kOther.contains(word);
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
    if (const std::string low = plain(word);
        !low.empty() && !is_side_word(low) && !(low == kNumbered && low.size() < word.size()))
      out += (out.empty() ? "" : "_") + word;
  return out;
}

int row_word(const std::string& name) {
  bool front = false, hind = false;
  for (const std::string& word : words_in(name)) {
    const std::string low = plain(word);
    front = front || kFront.contains(low);
    hind = hind || kHind.contains(low);
  }
  return front - hind;
}

}  // namespace legwright
