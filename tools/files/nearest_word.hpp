// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// The candidate with the smallest edit distance to `word`, if it is near enough to be meant; else
/// "".
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// The candidates, three at most, with the smallest edit distance to what a pattern stands for, in
/// which `*` is any text and `?` any letter.
std::vector<std::string> nearest_to_pattern(std::string_view pattern,
                                            const std::vector<std::string>& candidates);

}  // namespace legwright
