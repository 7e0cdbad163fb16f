// SPDX-License-Identifier: Apache-2.0
#include "tools/run/joined_by_and.hpp"

namespace legwright {

std::string joined_by_and(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return out;
}

}  // namespace legwright
