// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/assembly/module.hpp"
#include "tools/task/task_table.hpp"

namespace legwright {

/// Reads [slide] of a module file, what a linear actuator does.
/// @param needed whether what it must have is asked for: else the module is of another kind
ModuleSlide read_slide_table(TaskTable& in, Problems& problems, bool needed);

}  // namespace legwright
