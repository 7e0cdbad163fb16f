// SPDX-License-Identifier: Apache-2.0
#include "mjcf/affine.hpp"

#include <algorithm>

namespace legwright {

AffineVector stretched_point(const Eigen::Vector3d& point, const std::vector<Stretch>& stretches) {
  AffineVector out{point, {}};
  for (const Stretch& stretch : stretches) {
    const Eigen::Vector3d along = stretch.direction * stretch.direction.dot(point);
    if (along.isZero(0.0)) continue;
    out.constant -= along;
    out.slopes.push_back({stretch.parameter, along / stretch.initial});
  }
  return out;
}

Eigen::Matrix3d stretch_matrix(const std::vector<Stretch>& stretches, const Eigen::VectorXd& s) {
  Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
  for (const Stretch& stretch : stretches)
    map += stretch.direction * stretch.direction.transpose() *
           (s[stretch.parameter] / stretch.initial - 1.0);
  return map;
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
