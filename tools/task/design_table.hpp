// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "optimizer/design/design.hpp"
#include "tools/task/task_keys.hpp"
#include "tools/task/task_table.hpp"

namespace legwright {

DesignTable read_design_table(TaskTable in, Problems& problems);

/// The robot's design space with narrower bounds; a frozen parameter stays in it with equal bounds.
/// Throws InputError, with file and line of the key, for unknown names, for bounds that leave the
/// robot's or do not hold its value, and for given values beyond them.
DesignSpace restricted(const DesignSpace& space, const DesignTable& table, const std::string& file,
                       const std::map<std::string, int>& lines);

/// The body as it was at first: the robot's, but for what [design.given] says.
Eigen::VectorXd given_body(const DesignSpace& space, const DesignTable& table);

}  // namespace legwright
