// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// The candidate with the smallest edit distance to `word`, if it is near enough to be meant; else
/// "".
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// The candidate that `word` is but for one slip, two where it has eight letters: a letter that is
/// missing, too many, another one or exchanged with its neighbour; capitals do not count. Else "".
/// It is narrower than nearest(): for words of which most are meant as they are.
std::string slip_of(std::string_view word, const std::vector<std::string>& candidates);

/// The candidates, three at most, with the smallest edit distance to what a pattern stands for, in
/// which `*` is any text and `?` any letter.
std::vector<std::string> nearest_to_pattern(std::string_view pattern,
                                            const std::vector<std::string>& candidates);

}  // namespace legwright
