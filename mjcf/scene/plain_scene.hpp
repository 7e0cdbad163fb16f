// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// A scene that stock MuJoCo opens: includes the robot's file and adds floor, sky, light and the
/// numerics that robots are validated with. No plugin and no gait. Names that it adds are no
/// robot's: they get a number where the robot has them.
/// @param robot_xml the robot's file, as it stands beside the scene under `robot_file`, a plain
/// name.
/// @param friction of the floor, which holds against any of the feet.
std::string plain_scene(const RobotModel& robot, const std::string& robot_xml,
                        const std::string& robot_file, double friction);

}  // namespace legwright
