// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace legwright {

/// The first of a list, and how many more there are: "a, b, c and 4 more".
inline std::string listed(const std::vector<std::string>& all, std::size_t most = 3,
                          const char* between = ", ") {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(most, all.size()));
  return fmt::format("{}{}", fmt::join(all.begin(), all.begin() + shown, between),
                     all.size() > most ? fmt::format(" and {} more", all.size() - most) : "");
}

}  // namespace legwright
