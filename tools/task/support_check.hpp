// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// Which feet stand at once while the centre of mass of the home pose is farthest from their
/// support, where it is so far that the robot tips: three feet or more, or two across from each
/// other, as in a trot. Feet on one side or in one row (pace, bound) carry a robot in passing and
/// are not judged. Empty where all is well.
std::string unsupported_stance(const Task& task, const RobotModel& robot);

}  // namespace legwright
