// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/objective/objective.hpp"

namespace legwright::test {

/// A robot in its home pose that slides along its path, weight shared by the stance feet: feet and
/// COM are where the pose has them, to rounding. Not where Newton's method starts (initial_guess),
/// but known in every entry.
inline Eigen::VectorXd standing_motion(const Objective& objective, const Eigen::VectorXd& s) {
  const Morphology& robot = objective.morphology();
  const Layout& layout = objective.layout();
  const Gait& gait = objective.task().gait;
  const GeometryAtDesign geometry(robot, s);
  const int n = layout.design_size();
  PoseKinematics pose;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(robot.pose_size());
  q.tail(robot.joint_count()) = robot.nominal_joints();
  const auto place = [&](const Eigen::Vector3d& root, double heading) {
    q.head<3>() = root;
    q[5] = heading;
    pose.compute(robot, geometry, q, PoseDetail::place);
  };
  place(Eigen::Vector3d::Zero(), 0.0);
  Eigen::Vector3d lift(0.0, 0.0, -1e300);  // so that the lowest foot touches the ground
  for (int j = 0; j < robot.foot_count(); ++j)
    lift.z() = std::max(lift.z(), robot.feet[j].radius - foot_place(robot, geometry, pose, j).z());
  Eigen::VectorXd m = Eigen::VectorXd::Zero(layout.motion_size());
  for (int i = 0; i <= layout.knot_count(); ++i) {
    const double time = i * gait.time_step();
    place(objective.path().position(time) + lift, objective.path().heading(time));
    m.segment(layout.pose(i) - n, layout.pose_size()) = q;
    m.segment<3>(layout.com(i) - n) = pose.first_moment(0) / geometry.total_mass;
    int stance = 0;
    for (int j = 0; j < layout.foot_count(); ++j) {
      m.segment<3>(layout.foot(i, j) - n) = foot_place(robot, geometry, pose, j);
      stance += layout.force(i, j) >= 0 ? 1 : 0;
    }
    for (int j = 0; j < layout.foot_count(); ++j)
      if (layout.force(i, j) >= 0)
        m[layout.force(i, j) - n + 2] = robot.total_mass() * kGravity / stance;
  }
  return m;
}

}  // namespace legwright::test
