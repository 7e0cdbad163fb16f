// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/limbs.hpp"
#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// What of a robot seems to be in another unit than m, kg and rad: legs of many metres, a mass that
/// no robot of that size has, ranges of many turns. For people; one sentence each.
std::vector<std::string> doubtful_units(const RobotModel& robot, const std::vector<Limb>& limbs);

}  // namespace legwright
