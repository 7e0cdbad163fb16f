// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace legwright {

/// The first three of a list with what stands between them, and how many more there are.
inline std::string listed(const std::vector<std::string>& all, const char* between = ", ") {
  constexpr std::size_t kMost = 3;
  const auto shown = static_cast<std::ptrdiff_t>(std::min(kMost, all.size()));
  return fmt::format("{}{}", fmt::join(all.begin(), all.begin() + shown, between),
                     all.size() > kMost ? fmt::format(" and {} more", all.size() - kMost) : "");
}

}  // namespace legwright
