// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace legwright {

/// Whether the folders of a run hold a file of their own of this name, beside the robot's.
bool is_name_of_runs(std::string_view name);

}  // namespace legwright
