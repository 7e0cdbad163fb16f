// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/numbers.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include "plugin/number_text.hpp"
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"

namespace legwright::test {
namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void check_word(std::string_view word) {
  const auto value = parse_number(word);
  if (value) {
    promise(std::isfinite(*value), "a number that is not finite was read");
    const auto again = parse_number(format_number(*value));
    // Zero has no sign when it is written.
    promise(again && same_bits(*again, *value == 0.0 ? 0.0 : *value),
            "a number is another when it is written and read again");
    promise(rounded(rounded(*value)) == rounded(*value), "a rounded number is rounded further");
  }
  // The plugin reads less, and that alike.
  if (const auto read = read_number(word))
    promise(value && same_bits(*value, *read), "plugin and program read different numbers");
  else
    promise(!value || std::abs(*value) > kLargestNumber || word[0] == '+',
            "the plugin refuses what the program reads");
}

}  // namespace

bool fuzz_numbers(std::string_view text) {
  const auto words = split_words(text);
  bool all = true;
  for (const std::string_view word : words) {
    check_word(word);
    all = all && parse_number(word);
  }
  promise(words == split_blanks(text), "plugin and program split differently");
  const auto values = parse_numbers(text);
  promise(values.has_value() == all, "a list is read otherwise than its words");
  if (values) {
    const Eigen::Map<const Eigen::VectorXd> list(values->data(),
                                                 static_cast<Eigen::Index>(values->size()));
    promise(parse_numbers(format_numbers(list)) == values, "a list is another when read again");
  } else {
    promise(explain_bad_number(text).size() > 20, "a bad number without a reason");
  }
  const std::string_view inner = trimmed(text);
  promise(trimmed(inner) == inner && split_words(inner) == words, "trimming takes too much");
  return all && !words.empty();
}

}  // namespace legwright::test
