// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

#include "tools/simulate/scene.hpp"

namespace legwright {

/// What a foot feels of the ground at one moment.
struct FootTouch {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the foot, world axes [N]
  double normal = 0.0;                              // its part along the contacts' normals [N]
  double slip_speed = 0.0;  // of its fastest contact point, along the ground [m/s]
};

/// A foot with less than this share of the robot's weight on it does not stand.
inline constexpr double kStandingShare = 0.01;

/// Of the ball as which the plan has a foot [m]; 0 where it has a point.
double foot_radius(const mjModel& model, int geom);
/// Where the middle of that ball is, world axes [m].
Eigen::Vector3d foot_position(const mjModel& model, const mjData& data, int geom);

/// How a foot moves.
struct FootMotion {
  Eigen::Vector3d bottom_velocity;  // of the link at the ball's lowest point, world axes [m/s]
  Eigen::Vector2d roll_rate;        // of the link about the world's x and y [rad/s]
  Eigen::Vector3d bottom;           // the ball's lowest point, world [m]
};
FootMotion foot_motion(const mjModel& model, const mjData& data, int geom);

/// Adds up the contacts of each foot of the scene with the world, in the order of its feet.
/// @param data whose contacts and forces belong to one time
/// @return depth of the deepest contact of anything with the world [m], 0 where there is none
double read_foot_touches(const Scene& scene, const mjData& data, std::vector<FootTouch>& touches);

}  // namespace legwright
