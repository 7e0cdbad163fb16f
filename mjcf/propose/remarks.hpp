// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/limbs.hpp"
#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// What of how a robot is drawn may be a mistake, or is to be known: where it faces, legs that are
/// nearly mirror images, ranges that are none, joints that differ from those of the other legs,
/// motors without limit, masses that cannot be those of their shapes, links that overlap, feet that
/// touch elsewhere than they are drawn, and what touches the ground beside the feet.
std::vector<std::string> remarks_on(const RobotModel& robot, const std::vector<Limb>& limbs,
                                    const Facing& facing);

}  // namespace legwright
