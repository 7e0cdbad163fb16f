// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// With what a foot touches the ground in the home pose: "ball of 11 mm", "middle of 4 balls of
/// 6 mm", "middle of its sole, drawn 3.0 degrees askew and laid down", "edge of a box" …
std::string touching_part(const RobotModel& robot, int foot);

}  // namespace legwright
