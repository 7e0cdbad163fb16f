// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "mjcf/read_robot.hpp"
#include "tools/io/servo_sag.hpp"

namespace legwright {

/// A first task for a robot: few numbers, all of which follow from its size. SI units.
struct StarterTask {
  std::string gait;            // of the library
  double period = 0.0;         // [s]
  std::optional<double> duty;  // where it is more than the library's
  double speed = 0.0;          // ahead [m/s]
  ServoSag sag;                // of the file's servos; the task plays soft ones stiffer
};

/// Period in proportion to √(h/g) and speed to √(g h), with the height h of the COM in the home pose: what swings and
/// tips under gravity is slower in a larger robot. Without `gait`: trot for four feet, tripod for six, else the first of
/// the library. Throws InputError where the library has no gait for that many feet, or none of that name.
StarterTask starter_task(const RobotModel& robot, const std::optional<std::string>& gait);

/// The task file with its comments. `robot` is the path that it names, from the folder of the task file.
std::string starter_text(const StarterTask& task, const std::string& robot);

}  // namespace legwright
