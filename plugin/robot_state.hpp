// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "plugin/pd_playback.hpp"
#include "plugin/planned_motion.hpp"

namespace legwright {

/// The robot that an instance moves.
struct Robot {
  int root_body = -1;  // top of the tree in which its first joint is
  int root_qpos = -1;  // of the root's free joint; −1: it has none, the robot is fixed
};
Robot robot_of(const mjModel* m, const PdPlayback& playback) noexcept;

/// Where the free root is now.
Pose measured_root(const mjData* d, const Robot& robot) noexcept;

/// Writes planned root and asked-for joints at `time` [s] into `qpos`; leaves the rest of it.
void write_planned_pose(const mjModel* m, const PdPlayback& playback, const Robot& robot,
                        double time, mjtNum* qpos) noexcept;

}  // namespace legwright
