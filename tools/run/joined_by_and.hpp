// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace legwright {

/// "a, b and c".
std::string joined_by_and(const std::vector<std::string>& parts);

}  // namespace legwright
