// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

/// Where a model keeps the free root and the hinges that a trajectory moves.
struct JointMap {
  int root_body = -1, root_qpos = -1, root_dof = -1;
  std::vector<int> joint, qpos, dof;  // in the order of the trajectory's joints
};

/// Throws MujocoError where the model has no free joint, or lacks a hinge of that name.
JointMap map_joints(const mjModel& model, const std::vector<std::string>& joint_names);

/// Weight of the robot in the model's gravity, whichever way that points [N].
double robot_weight(const mjModel& model, const JointMap& map);

/// MuJoCo's state of the played motion: root velocity in world axes, angular velocity in the
/// trunk's.
struct PlayedState {
  Eigen::VectorXd qpos, qvel, qacc;
};

/// The played B-spline at `time` [s] as a state of the model; what the trajectory does not move
/// stays in qpos0. The derivatives are exact. Plans that turn go round their circle.
PlayedState played_state(const mjModel& model, const JointMap& map, const Trajectory& trajectory,
                         double time);

}  // namespace legwright
