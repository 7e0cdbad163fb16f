// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/limbs.hpp"
#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// What a leg needs to carry its share of the robot while it is stretched out level [N m].
double carrying_torque(const Morphology& morphology);

/// What of a robot seems to be in another unit than m, kg and rad, or made up: legs of many metres,
/// a mass that no robot of that size has, ranges of many turns, torques of a machine many times as
/// heavy. For people; one sentence each.
std::vector<std::string> doubtful_units(const RobotModel& robot, const std::vector<Limb>& limbs);

}  // namespace legwright
