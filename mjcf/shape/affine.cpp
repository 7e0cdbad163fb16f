// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/affine.hpp"

#include <algorithm>

namespace legwright {

namespace {

/// What lies at `along` from where a stretch moves nothing goes with it.
void add_stretch(const Stretch& stretch, double along, AffineVector& to) {
  const Eigen::Vector3d part = stretch.direction * along;
  if (part.isZero(0.0)) return;
  to.constant -= part;
  to.slopes.push_back({stretch.parameter, part / stretch.initial});
}

}  // namespace

AffineVector stretched_point(const Eigen::Vector3d& point, const std::vector<Stretch>& stretches) {
  AffineVector out{point, {}};
  for (const Stretch& stretch : stretches)
    add_stretch(stretch, stretch.direction.dot(point) - stretch.still, out);
  return out;
}

AffineVector stretched_arm(const Eigen::Vector3d& arm, const std::vector<Stretch>& stretches) {
  AffineVector out{arm, {}};
  for (const Stretch& stretch : stretches) add_stretch(stretch, stretch.direction.dot(arm), out);
  return out;
}

AffineVector placed_point(const Eigen::Vector3d& point, const std::vector<Stretch>& stretches,
                          const std::vector<Place>& places) {
  AffineVector out = stretched_point(point, stretches);
  for (const Place& place : places) {
    out.constant[place.axis] = 0.0;
    for (AffineVector::Slope& slope : out.slopes) slope.slope[place.axis] = 0.0;
  }
  for (const Place& place : places)
    out = sum(out, {Eigen::Vector3d::Zero(),
                    {{place.parameter, place.factor * Eigen::Vector3d::Unit(place.axis)}}});
  return out;
}

Eigen::Matrix3d stretch_matrix(const std::vector<Stretch>& stretches, const Eigen::VectorXd& s) {
  Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
  for (const Stretch& stretch : stretches)
    map += stretch.direction * stretch.direction.transpose() *
           (s[stretch.parameter] / stretch.initial - 1.0);
  return map;
}

Eigen::Vector3d stretch_shift(const std::vector<Stretch>& stretches, const Eigen::VectorXd& s) {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (const Stretch& stretch : stretches)
    shift -= stretch.direction * stretch.still * (s[stretch.parameter] / stretch.initial - 1.0);
  return shift;
}

AffineVector sum(const AffineVector& a, const AffineVector& b) {
  AffineVector out = a;
  out.constant += b.constant;
  for (const AffineVector::Slope& slope : b.slopes) {
    const auto same = std::find_if(out.slopes.begin(), out.slopes.end(), [&](const auto& own) {
      return own.parameter == slope.parameter;
    });
    if (same == out.slopes.end())
      out.slopes.push_back(slope);
    else
      same->slope += slope.slope;
  }
  return out;
}

AffineVector negative(const AffineVector& a) {
  AffineVector out{-a.constant, a.slopes};
  for (AffineVector::Slope& slope : out.slopes) slope.slope = -slope.slope;
  return out;
}

AffineVector rotated(const Eigen::Matrix3d& rotation, const AffineVector& a) {
  AffineVector out{rotation * a.constant, a.slopes};
  for (AffineVector::Slope& slope : out.slopes) slope.slope = rotation * slope.slope;
  return out;
}

}  // namespace legwright
