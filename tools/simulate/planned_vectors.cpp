// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/planned_vectors.hpp"

namespace legwright {
namespace {

Eigen::Vector3d vector(const Point& point) { return Eigen::Vector3d::Map(point.data()); }

}  // namespace

PlannedPoint planned_point(const Trajectory& plan, const SplinePhase& phase, int column) {
  const MovingPoint point = PlannedMotion(plan).point(phase, column);
  return {vector(point.value), vector(point.rate), vector(point.acceleration)};
}

Eigen::Vector3d planned_force(const Trajectory& plan, const SplinePhase& phase, int foot) {
  return vector(PlannedMotion(plan).force(phase, foot));
}

}  // namespace legwright
