// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/task.hpp"
#include "tools/task/task_keys.hpp"
#include "tools/task/task_table.hpp"

namespace legwright {

/// The table [style]: what eqs (10) shall pull COM, feet and joints to, constant or as lists over
/// the cycle. What is wrong goes to the reader's problems.
void read_style(TaskTable in, TaskFile& task);

/// Puts the file's style targets into the task, feet and joints in the robot's order. Throws
/// InputError, with file and line of the key, where they do not fit the robot's feet and joints.
/// @param order footfall_order() of the robot
void apply_style(const TaskFile& file, const RobotModel& robot, const std::vector<int>& order,
                 Task& task);

/// The greatest height that the task wants a foot to have while it swings, of a foot that has a
/// target [m]: 0 where all that is high falls into its stance.
double highest_swing(const Task& task, int foot);

/// The highest com_height that the task asks for at any time [m]; nothing where it is left to the
/// home pose.
std::optional<double> highest_com(const Task& task);

}  // namespace legwright
