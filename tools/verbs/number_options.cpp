// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/number_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include "mjcf/text/numbers.hpp"

namespace legwright {

CLI::Validator number_between(double low, double high) {
  const bool open = high == std::numeric_limits<double>::max();
  const std::string expected =
      open ? (low == -high ? "a finite number" : fmt::format("a finite number from {} on", low))
           : fmt::format("a number from {} to {}", low, high);
  const std::string in_help = open ? (low == -high ? "" : fmt::format("from {} on", low))
                                   : fmt::format("{} to {}", low, high);
  return {[=](std::string& text) {
            const auto number = parse_number(text);
            return number && *number >= low && *number <= high
                       ? std::string()
                       : fmt::format("'{}' is not {}", text, expected);
          },
          in_help};
}

CLI::Validator finite_number() {
  constexpr double kMost = std::numeric_limits<double>::max();
  return number_between(-kMost, kMost);
}

CLI::Validator number_from_zero() {
  return number_between(0.0, std::numeric_limits<double>::max());
}

CLI::Validator seed_number() {
  return {[](std::string& text) {
            std::uint64_t seed = 0;
            const char* const end = text.data() + text.size();
            const auto [at, error] = std::from_chars(text.data(), end, seed);
            return error == std::errc() && at == end
                       ? std::string()
                       : fmt::format("'{}' is not a whole number from 0 to {}", text,
                                     std::numeric_limits<std::uint64_t>::max());
          },
          ""};
}

}  // namespace legwright
