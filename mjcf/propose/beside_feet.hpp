// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// What of a leg touches level ground beside its foot once the leg leans by a few degrees from the
/// home pose: a shank on which the robot would walk, of which the plan knows nothing. A sentence
/// with the cure for each such foot; flat feet, which carry with all their geoms, are left out.
/// Throws InputError where the robot's text is no model.
std::vector<std::string> beside_feet(const RobotModel& robot);

}  // namespace legwright
