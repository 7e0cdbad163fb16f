// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// A sentence where feet touch elsewhere than what is drawn of them, in the home pose: a box around
/// a bent shin stands on its corner, the mesh on its end. Compared are the lowest point of what
/// collides of the last link and that of its meshes that only show.
std::vector<std::string> feet_beside_pictures(const RobotModel& robot);

}  // namespace legwright
