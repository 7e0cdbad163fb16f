// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/task/task_table.hpp"

namespace legwright {

/// Reads lever and mount of a joint of an assembly, whose servo and axis are known, and tells where
/// a linear actuator cannot turn it.
/// @param first whether the joint is the first of its limb
void read_linear_pivots(TaskTable& in, Problems& problems, bool first, AssemblyJoint& joint);

}  // namespace legwright
