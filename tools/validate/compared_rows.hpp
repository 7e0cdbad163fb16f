// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugin/trajectory.hpp"

namespace legwright {

/// Rows of what is compared between plan and physics: first those of the whole robot, then those of
/// each foot, then those of each joint.
struct ComparedRows {
  enum Whole {
    speed,  // of the COM along the wanted direction [m/s]
    heading_error,
    com_x,  // of the COM against an even motion from where it was at the start of the cycle [m]
    com_y,
    com_height,
    trunk_height,
    roll,
    pitch,
    yaw,  // of the trunk against a heading that turns evenly [rad]
    power,
    saturated,
    tracking,
    whole_count
  };
  enum Foot { ahead, left, normal, tangential, height, slip_speed, friction, contact, foot_count };
  enum Joint { angle, torque, joint_power, joint_count };

  explicit ComparedRows(const Trajectory& plan)
      : feet(plan.foot_count()), joints(plan.joint_count()) {}
  int foot(int index, Foot part) const { return whole_count + foot_count * index + part; }
  int joint(int index, Joint part) const {
    return whole_count + foot_count * feet + joint_count * index + part;
  }
  int count() const { return joint(joints, angle); }

  int feet, joints;
};

}  // namespace legwright
