// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// Largest magnitude that is read, the bound beyond which MuJoCo itself calls a number bad. It
/// keeps every sum and product that playback forms finite.
inline constexpr double kLargestNumber = 1e10;

/// The number that `token` spells, whole and in plain decimals; nothing for anything else: text
/// after it, hex, a leading +, nan, inf, a magnitude above kLargestNumber. Does not look at the
/// locale.
std::optional<double> read_number(std::string_view token);

/// The parts of `text` between blanks, tabs and line breaks; they point into `text`.
std::vector<std::string_view> split_blanks(std::string_view text);

/// `token` in quotes, made fit for a message: at most 40 bytes of it, unprintable ones replaced.
std::string quoted(std::string_view token);

}  // namespace legwright
