// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// Why no gait is possible: a foot that none of its leg's joints raises or lowers, as where those
/// that would are coupled or held. Names the foot, and what to do; empty where there is none.
std::string stuck_foot_text(const RobotModel& robot);

}  // namespace legwright
