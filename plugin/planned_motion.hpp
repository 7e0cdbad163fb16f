// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "plugin/spline.hpp"
#include "plugin/trajectory.hpp"

namespace legwright {

using Point = std::array<double, 3>;  // world [m], or a force in world axes [N]

/// Where a body is: position of its frame [m] and unit quaternion w, x, y, z, world from body.
struct Pose {
  Point position{};
  std::array<double, 4> quaternion{1.0, 0.0, 0.0, 0.0};
};

/// A planned point of the world with its time derivatives [m, m/s, m/s²].
struct MovingPoint {
  Point value{}, rate{}, acceleration{};
};

/// The plan in the world at any time. One cycle later everything is the same up to one rigid motion
/// of the ground, p ↦ R(turn)·(p − r) + r + travel with r the root at knot 0, so that a plan on a
/// circle stays on it. Without turn this is what spline_point has with drift `travel`.
/// Copies a few numbers; the trajectory must outlive it.
class PlannedMotion {
 public:
  explicit PlannedMotion(const Trajectory& trajectory) noexcept;

  /// The played B-spline of three columns (root, COM or a foot), its control points moved on from
  /// cycle to cycle. @param column the first of the three
  MovingPoint point(const SplinePhase& phase, int column) const noexcept;
  Pose root(const SplinePhase& phase) const noexcept;
  Point com(const SplinePhase& phase) const noexcept;
  Point foot(const SplinePhase& phase, int foot) const noexcept;
  /// On the foot; interpolated linearly.
  Point force(const SplinePhase& phase, int foot) const noexcept;
  bool contact(const SplinePhase& phase, int foot) const noexcept;  // of the nearest knot

 private:
  /// The point that is `p` in cycle 0, `cycles` later.
  Point moved(const Point& p, double cycles) const noexcept;

  const Trajectory* trajectory_;
  std::array<double, 2> pivot_;  // root at knot 0, on the ground
};

}  // namespace legwright
