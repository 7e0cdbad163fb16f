// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace legwright {

/// The wanted path of the COM on the ground: constant velocity in the heading frame and constant
/// turn rate, starting at the origin with heading +x. One cycle later everything is the same up to
/// a rigid motion of the plane, p ↦ turn·p + travel.
class WantedPath {
 public:
  WantedPath() = default;
  /// @param velocity forward, left [m/s] @param turn_rate [rad/s] @param period [s]
  WantedPath(const Eigen::Vector2d& velocity, double turn_rate, double period);

  Eigen::Vector3d position(double time) const;                     // [m], z = 0
  double heading(double time) const { return turn_rate_ * time; }  // [rad]
  /// From the heading frame to the world, on the ground.
  Eigen::Matrix2d heading_rotation(double time) const {
    return yaw_rotation(heading(time)).topLeftCorner<2, 2>();
  }
  /// The inverse of position(): the constant velocity in the heading frame that leads by `step`,
  /// seen in the frame at its start, while the heading turns by `angle` at a constant rate. Not a
  /// number where the turn is a full circle, which leads back whatever the velocity.
  static Eigen::Vector2d velocity_along_arc(const Eigen::Vector2d& step, double angle, double time);
  static Eigen::Matrix3d yaw_rotation(double angle);

  /// One cycle's rigid motion.
  const Eigen::Vector3d& travel() const { return travel_; }
  const Eigen::Matrix3d& turn() const { return turn_; }
  double turn_angle() const { return turn_angle_; }

 private:
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();
  double turn_rate_ = 0.0, turn_angle_ = 0.0;
  Eigen::Vector3d travel_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
};

}  // namespace legwright
