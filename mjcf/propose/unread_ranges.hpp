// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Joints of legs whose `range` is none, as its upper end is not above its lower one: MuJoCo takes
/// any angle then, and so does the plan. A sentence with the cure; empty where there is none.
std::vector<std::string> unread_ranges(const RobotModel& robot);

}  // namespace legwright
