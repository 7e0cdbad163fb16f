// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

/// A ball foot as MuJoCo's Jacobians need it.
struct FootOnLink {
  std::string joint;    // the hinge of the link that carries it; empty: the trunk
  double radius = 0.0;  // [m]
};

/// What inverse dynamics leaves for the trunk to explain: zero where plan and physics agree.
struct RootResidual {
  double force = 0.0;   // largest over the knots, share of the weight
  double torque = 0.0;  // the same about the root [N m], trunk frame
  /// Moment arms of the tendons over each joint [m], knot by joint; 0 where there is none.
  Eigen::MatrixXd arms;
};

/// Fills the trajectory's feed-forward torques: at each knot MuJoCo's inverse dynamics of the
/// played motion (gravity, armature, joint damping and springs included) minus Jᵀ·planned force at
/// each foot's lowest point, and what dry friction of the joints takes.
/// @param feet in the trajectory's order. Throws MujocoError where model and trajectory do not fit.
RootResidual fill_feed_forward(const mjModel& model, const std::vector<FootOnLink>& feet,
                               Trajectory& trajectory);

}  // namespace legwright
