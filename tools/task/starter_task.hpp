// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "tools/task/servo_sag.hpp"
#include "tools/task/two_feet.hpp"

namespace legwright {

/// A first task for a robot: few numbers, all of which follow from its size. SI units.
struct StarterTask {
  std::string gait;                                  // of the library
  double period = 0.0;                               // [s]
  std::optional<double> duty;                        // where it is more than the library's
  double speed = 0.0;                                // ahead [m/s]
  Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();  // in the trunk's frame (facing_of())
  std::optional<int> knots;            // where swings are too short for the usual ones
  std::optional<double> swing_height;  // where it is not the usual share of the leg [m]
  ServoSag sag;                        // of the file's servos; the task plays soft ones stiffer
  TwoFeet two_feet;                    // so it does with ankles of flat feet
  bool slowed = false;                 // to what damping leaves of the motors
  bool in_degrees = false;             // the robot's file
};

/// Period in proportion to √(h/g) and speed to √(g h), with the height h of the COM in the home
/// pose: what swings and tips under gravity is slower in a larger robot. Without `gait`: trot for
/// four feet, else the first of the library: walk, tripod, tetrapod, wave. Throws InputError where
/// the library has no gait for that many feet (no_gait_text()), or none of that name.
StarterTask starter_task(const RobotModel& robot, const std::optional<std::string>& gait);

/// What to do where the library has no gait for so many feet: how a task file declares one. Empty
/// where there is a gait.
std::string no_gait_text(int foot_count);
/// Why there is no first task for a robot, and what to do: it has no gait, or would fall with any.
/// Empty where there is.
std::string no_task_text(const RobotModel& robot);

/// The task file with its comments. `robot` is the path that it names, from the folder of the task
/// file.
std::string starter_text(const StarterTask& task, const std::string& robot);

}  // namespace legwright
