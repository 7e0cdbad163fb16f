// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// Before a foot's name: the site at the point that the plan moves, in scenes where that is not the
/// middle of a ball. A ball of the foot's radius; a box where that is zero.
inline constexpr const char* kFootSite = "foot:";

/// The robot as it is played: what the plan holds is fixed in the home pose (its joints are gone,
/// with their actuators, tendons, constraints, sensors and numbers of keyframes), and each foot is
/// a colliding geom with the name that the plan has for it. The same text where nothing is held and
/// all feet are balls with names, and no name is one of the scene's (make_room). Comments stay,
/// blanks do not.
/// @param design_xml text of the robot or of a design of it. Throws InputError if it does not
///        compile, std::invalid_argument if it is another robot.
std::string played_robot(const RobotModel& robot, const std::string& design_xml);

}  // namespace legwright
