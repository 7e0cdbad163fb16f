// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/motion/task.hpp"
#include "tools/task/starter_task.hpp"

namespace legwright {

/// A first task slowed down to what the damping of a robot's joints leaves of their motors: low
/// steps, a cycle that is long enough to lift a foot so far, and a speed at which it gets ahead
/// meanwhile. As it was where no joint is slower than kUsualJointSpeed.
/// @param duty share of the cycle that a foot stands, the longest
void slow_down_for_damping(const RobotModel& robot, double duty, StarterTask& task);

/// About the speed that a task asks of joints [rad/s], from how fast it lifts feet and puts them
/// ahead; kUsualJointSpeed at most.
double asked_joint_speed(const RobotModel& robot, const Task& task);

}  // namespace legwright
