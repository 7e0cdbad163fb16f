// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// The robot's MJCF text as the task has it: with the payload as a body "payload" on its trunk, or
/// "payload_2" where the robot has one (a box that is seen and weighs, but touches nothing), and
/// with gravity as the ground sees it. The very same text where the task has neither.
/// @param robot_xml text of `robot` or a design of it. Throws InputError where the robot's compiler
/// would change what the payload weighs.
std::string in_surroundings(const RobotModel& robot, const std::string& robot_xml,
                            const Task& task);

/// The same robot with servos no stronger, and played no softer, than the task says; those of
/// linear actuators stay.
RobotModel with_task_servos(RobotModel robot, const Task& task);
/// The same with the payload and the weaker motors of the task, too: the robot that stands and
/// walks.
RobotModel as_played(const RobotModel& robot, const Task& task);

/// Against gravity in a model, unit vector; exactly z where gravity is along z.
Eigen::Vector3d up_of(const mjModel& model);

/// The smallest rotation that takes z against gravity: how a ground lies, and how cameras turn so
/// that up in a picture is against gravity. Identity where gravity is along z.
Eigen::Matrix3d ground_rotation(const mjModel& model);

}  // namespace legwright
