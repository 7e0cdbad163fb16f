// SPDX-License-Identifier: Apache-2.0
#include "plugin/robot_state.hpp"

#include <algorithm>

namespace legwright {

Robot robot_of(const mjModel* m, const PdPlayback& playback) noexcept {
  Robot robot;
  robot.root_body = m->body_rootid[m->jnt_bodyid[playback.servos().front().joint]];
  const int joint = m->body_jntadr[robot.root_body];
  if (joint >= 0 && m->jnt_type[joint] == mjJNT_FREE) robot.root_qpos = m->jnt_qposadr[joint];
  return robot;
}

Pose measured_root(const mjData* d, const Robot& robot) noexcept {
  Pose pose;
  std::copy_n(d->qpos + robot.root_qpos, 3, pose.position.begin());
  std::copy_n(d->qpos + robot.root_qpos + 3, 4, pose.quaternion.begin());
  mju_normalize4(pose.quaternion.data());
  return pose;
}

void write_planned_pose(const mjModel* m, const PdPlayback& playback, const Robot& robot,
                        double time, mjtNum* qpos) noexcept {
  const SplinePhase phase = playback.phase(time);
  const Blend blend = blend_at(playback.clock(), time);
  if (robot.root_qpos >= 0) {
    const Pose root = PlannedMotion(playback.trajectory()).root(phase);
    std::copy_n(root.position.begin(), 3, qpos + robot.root_qpos);
    std::copy_n(root.quaternion.begin(), 4, qpos + robot.root_qpos + 3);
  }
  for (const Servo& servo : playback.servos())
    qpos[m->jnt_qposadr[servo.joint]] = playback.target(servo, phase, blend).position;
}

}  // namespace legwright
