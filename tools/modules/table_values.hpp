// SPDX-License-Identifier: Apache-2.0
// Values of keys that modules and assemblies share.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/task/task_table.hpp"

namespace legwright {

/// Three numbers as a vector.
Eigen::Vector3d vector_of(const std::vector<double>& values);

/// A name of letters, digits, `_`, `-` and `others`, without `--`, which no comment of MJCF may
/// hold.
bool is_plain_name(std::string_view name, std::string_view others = "");

/// The unit vector along three numbers of any length. Adds a problem for one without a length.
/// @return nothing where the key is not there, or has none
std::optional<Eigen::Vector3d> direction_in(TaskTable& in, std::string_view key,
                                            Problems& problems);

/// Least and largest angle [rad]. Adds a problem where the lesser one is not first.
/// @return nothing where the key is not there, or has none
std::optional<std::array<double, 2>> angle_range_in(TaskTable& in, std::string_view key,
                                                    Problems& problems);

}  // namespace legwright
