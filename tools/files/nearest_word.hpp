// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// The candidate with the smallest edit distance to `word`, if it is near enough to be meant; else
/// "".
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace legwright
