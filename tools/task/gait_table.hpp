// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/motion/gait.hpp"
#include "tools/task/task_keys.hpp"
#include "tools/task/task_table.hpp"

namespace legwright {

/// The table [gait]: a name of the library, or a pattern of one's own by `touchdown` and `duty`.
/// What is wrong goes to the reader's problems.
void read_gait(TaskTable in, TaskFile& task);

/// The gait that the file asks for, of a robot whose feet have these names and this footfall order.
/// Throws InputError, with file and line of the key, where the two do not fit or a foot would stand
/// for less than two knots.
Gait make_gait(const TaskFile& file, const std::vector<std::string>& names,
               const std::vector<int>& order);

/// The longest stance of any foot in that gait, as a share of the cycle: the pattern's own, not
/// rounded to knots.
double longest_duty(const TaskFile& file, const std::vector<std::string>& names,
                    const std::vector<int>& order);

}  // namespace legwright
