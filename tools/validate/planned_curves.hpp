// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "tools/simulate/scene.hpp"
#include "tools/validate/measure.hpp"

namespace legwright {

/// Roll, pitch and yaw of a rotation Rz(yaw)·Ry(pitch)·Rx(roll), row by row as MuJoCo keeps it.
struct TrunkAngles {
  double roll, pitch, yaw;
};
TrunkAngles trunk_angles(const mjtNum* rotation);

/// The direction along which speed is looked at, heading frame: the wanted one, or ahead.
Eigen::Vector2d speed_direction(const WantedMotion& wanted);

/// What the played plan has in the place of each of ComparedRows at the centres of `bins` equal
/// parts of its cycle; not a number where it has no say. Joint power is that of the feed-forward
/// torque.
Eigen::MatrixXd planned_curves(const Scene& scene, const WantedMotion& wanted, int bins);

/// Yaw of the trunk in the plan at phase 0 [rad].
double planned_yaw(const Scene& scene);

}  // namespace legwright
