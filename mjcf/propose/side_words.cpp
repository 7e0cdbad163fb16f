// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/side_words.hpp"

#include <array>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace legwright {
namespace {

using Words = std::set<std::string>;
const Words kFront{"fl", "fr", "lf", "rf", "front", "fore", "f"};
const Words kHind{"hl", "hr", "rl", "rr",   "bl",   "br",   "lh", "rh",
                  "lr", "lb", "rb", "hind", "rear", "back", "h"};
const Words kLeft{"l", "left", "fl", "lf", "hl", "rl", "bl", "lh", "lr", "lb", "lm", "ml"};
const Words kRight{"r", "right", "fr", "rf", "hr", "rr", "br", "rh", "rb", "rm", "mr"};
const Words kOther{"l", "r", "left", "right", "middle", "mid", "lm", "rm", "ml", "mr"};

constexpr std::array<std::string_view, 8> kWritten{"front", "fore", "hind",  "rear",
                                                   "back",  "left", "right", "middle"};
/// What begins after the letters of a leg where no capital says so: "FRleg".
constexpr std::array<std::string_view, 16> kParts{
    "leg", "hip",  "thigh", "calf",  "shank", "knee",     "foot",  "ankle",
    "toe", "coxa", "femur", "tibia", "upper", "shoulder", "lower", "abad"};
const char* const kNumbered = "leg";  // with a number it tells which leg, too

bool is_side_word(const std::string& word) {
  return kFront.contains(word) || kHind.contains(word) || kOther.contains(word);
}

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_number_or_letter(char c) {
  return is_capital(c) || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

std::string in_small_letters(std::string word) {
  for (char& c : word)
    if (is_capital(c)) c = static_cast<char>(c - 'A' + 'a');
  return word;
}

template <class Starts>
std::size_t length_of_start(const std::string& word, const Starts& starts) {
  for (const std::string_view start : starts)
    if (word.starts_with(start)) return start.size();
  return 0;
}

/// Of the first of words that stand together: "FrontRight", "frontright", "FRLeg", "FRleg".
std::size_t first_length(const std::string& together) {
  const std::string low = in_small_letters(together);
  if (const std::size_t side = length_of_start(low, kWritten); side > 0)
    if (side == low.size() || together[side] < 'a' || length_of_start(low.substr(side), kWritten))
      return side;
  std::size_t end = 0;
  while (end < together.size() && is_capital(together[end])) ++end;
  if (end > 1 && end < together.size() && together[end] >= 'a') {
    const bool side = is_side_word(low.substr(0, end)) && length_of_start(low.substr(end), kParts);
    return side ? end : end - 1;
  }
  while (end < together.size() && !is_capital(together[end])) ++end;
  return end;
}

struct Word {
  std::string text, low;  // low: in small letters, without the number at the end
  bool joined = false;    // to the one before it
  bool lone = true;       // joined to none

  bool is_in(const Words& words) const { return (lone || low.size() > 1) && words.contains(low); }
  /// A single letter in the midst of a name says left or right, nothing else.
  bool tells_side() const {
    return is_in(kFront) || is_in(kHind) || kOther.contains(low) ||
           (low == kNumbered && low.size() < text.size());
  }
};

/// Those that are parted by other signs than letters and digits, or by a capital.
std::vector<Word> words_in(const std::string& name) {
  std::vector<Word> out;
  for (std::size_t at = 0; at < name.size(); ++at) {
    std::string together;
    while (at < name.size() && is_number_or_letter(name[at])) together += name[at++];
    for (bool joined = false; !together.empty(); joined = true) {
      Word word;
      word.text = together.substr(0, first_length(together));
      together.erase(0, word.text.size());
      word.low = in_small_letters(word.text);
      while (!word.low.empty() && word.low.back() >= '0' && word.low.back() <= '9')
        word.low.pop_back();
      word.joined = joined;
      word.lone = !joined && together.empty();
      out.push_back(std::move(word));
    }
  }
  return out;
}

/// 1 where a word of a name is one of `these`, −1 where one is of `those`, 0 where neither or both.
template <class Test>
int word_of(const std::string& name, const Words& these, const Words& those, const Test& is_in) {
  bool is_this = false, is_that = false;
  for (const Word& word : words_in(name)) {
    is_this = is_this || is_in(word, these);
    is_that = is_that || is_in(word, those);
  }
  return is_this - is_that;
}

}  // namespace

std::string without_side(const std::string& name) {
  std::string out;
  for (const Word& word : words_in(name))
    if (!word.low.empty() && !word.tells_side())
      out += (out.empty() || word.joined ? "" : "_") + word.text;
  return out;
}

int row_word(const std::string& name) {
  return word_of(name, kFront, kHind,
                 [](const Word& word, const Words& in) { return word.is_in(in); });
}

int lateral_word(const std::string& name) {
  return word_of(name, kLeft, kRight,
                 [](const Word& word, const Words& in) { return in.contains(word.low); });
}

}  // namespace legwright
