// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/limbs.hpp"
#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// Legs without a mirror image that would be a pair but for a hand's breadth, as where one number
/// of a file is wrong: a sentence for each two, empty where there are none.
std::vector<std::string> nearly_mirrored(const RobotModel& robot, const std::vector<Limb>& limbs,
                                         Across across);

}  // namespace legwright
