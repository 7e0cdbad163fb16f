// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {

/// Where a task has a robot face another way than the robot's file means it, a sentence each: by
/// the names of its legs, its hips or its camera (facing_of()), where the task has it face +x, the
/// default; and by design parameters that tie legs as mirror images across an axis along which it
/// then walks.
std::vector<std::string> facing_warnings(const TaskFile& task, const RobotModel& robot);

}  // namespace legwright
