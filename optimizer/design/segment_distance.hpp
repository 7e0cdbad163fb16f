// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace legwright {

/// How much of a distance is worked out.
enum class DistanceDetail { value, gradient, hessian };

/// Distance of eq (16) between two segments, p₁q₁ and p₂q₂, as a function of their four ends (p₁,
/// q₁, p₂, q₂).
struct SegmentDistance {
  double value = 0.0;                     // [m]
  Eigen::Matrix<double, 12, 1> gradient;  // in the ends
  Eigen::Matrix<double, 12, 12> hessian;  // both triangles
};

/// Closed form: the parameter s of the nearest point on the first segment is that of the two lines,
/// clamped to [0, 1]; t on the second is nearest to it, clamped; then s is nearest to that,
/// clamped. Exact to rounding where no clamp is near its edge. Made twice differentiable
/// everywhere:
/// - the clamps are rounded over a twentieth of the length to either side of their edges (quartic).
///   The pair of points stays inside the segments, so the result is never below the distance; its
///   square is above that of the distance by less than a thousandth of the longer length's square;
/// - the lines' own parameter has the pole 1/sin² of their angle. Below sin² = 0.03 (10°) 1/sin² is
///   continued by the parabola with the same value and two derivatives, about the middle of the
///   first segment. Between parallel segments, where the distance itself has a ridge, the nearest
///   points so glide from end to end;
/// - below `rounding` the root of the squared distance is continued by the parabola in it with the
///   same value and two derivatives, finite and level where the segments cross.
/// A segment without length counts as a point. @param detail what it does not name is left alone.
SegmentDistance segment_distance(const Eigen::Vector3d& p1, const Eigen::Vector3d& q1,
                                 const Eigen::Vector3d& p2, const Eigen::Vector3d& q2,
                                 double rounding, DistanceDetail detail = DistanceDetail::hessian);

}  // namespace legwright
