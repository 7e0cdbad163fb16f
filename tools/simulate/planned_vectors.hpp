// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "plugin/planned_motion.hpp"
#include "plugin/trajectory.hpp"

namespace legwright {

/// MovingPoint as vectors.
struct PlannedPoint {
  Eigen::Vector3d value, rate, acceleration;  // [m, m/s, m/s²]
};

/// What the plugin has as PlannedMotion::point() and force(), for those who calculate with vectors.
/// @param column the first of three: root, COM or a foot
PlannedPoint planned_point(const Trajectory& plan, const SplinePhase& phase, int column);
Eigen::Vector3d planned_force(const Trajectory& plan, const SplinePhase& phase, int foot);

}  // namespace legwright
