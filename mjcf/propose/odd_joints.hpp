// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Joints of legs that differ from those in their place in all other legs of that many joints, as
/// where one number of a file is wrong or missing: one without a range where all others have one,
/// and one about the lateral axis whose sign lets its leg bend the other way than all others. A
/// sentence each; of robots with fewer than three such legs nothing is certain.
std::vector<std::string> odd_joints(const RobotModel& robot);

/// The sentence on servos whose torque nobody limits; empty where all have limits.
std::string unlimited_torques(const RobotModel& robot);

/// Joint speed below which no usual gait keeps [rad/s].
inline constexpr double kUsualJointSpeed = 2.0;

/// The speed at which damping takes all that its motor gives, of the joint where that is least; no
/// less than `most` where none is slower. @param limit of a task, on all motors [N m]
double damped_joint_speed(const RobotModel& robot, std::optional<double> limit = {},
                          double most = kUsualJointSpeed);

/// The sentence on joints whose damping takes all that their motors give at a speed below `needed`;
/// empty where there are none. @param limit of a task, on all motors [N m]
std::string overdamped_joints(const RobotModel& robot, std::optional<double> limit = {},
                              double needed = kUsualJointSpeed);

}  // namespace legwright
