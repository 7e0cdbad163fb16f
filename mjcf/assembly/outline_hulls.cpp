// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/outline_hulls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjcf/shape/convex_distance.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr int kRoundCorners = 16;

OutlineHull outline_hull(const OutlineShape& shape, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3d at = pose * shape.pose();
  const Vector3d half = shape.half();
  OutlineHull out;
  if (shape.type == OutlineShape::Type::sphere) return {{at.translation()}, half.x()};
  if (shape.type == OutlineShape::Type::box) {
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
          out.points.push_back(at * half.cwiseProduct(Vector3d(x, y, z)));
    return out;
  }
  const double round = half.x() / std::cos(std::numbers::pi / kRoundCorners);
  for (int k = 0; k < kRoundCorners; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / kRoundCorners;
    for (const double z : {-half.z(), half.z()})
      out.points.push_back(at * Vector3d(round * std::cos(turn), round * std::sin(turn), z));
  }
  return out;
}

}  // namespace

OutlineHulls outline_hulls(const Module& module, const Eigen::Isometry3d& pose) {
  OutlineHulls out;
  for (const OutlineShape& shape : module.outline) out.push_back(outline_hull(shape, pose));
  return out;
}

OutlineHulls moved(OutlineHulls hulls, const Eigen::Isometry3d& by) {
  for (OutlineHull& hull : hulls)
    for (Vector3d& point : hull.points) point = by * point;
  return hulls;
}

double hull_distance(const OutlineHull& a, const OutlineHull& b) {
  return std::max(0.0, convex_distance(a.points, b.points) - a.radius - b.radius);
}

double hull_distance(const OutlineHulls& a, const OutlineHulls& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const OutlineHull& one : a)
    for (const OutlineHull& other : b) least = std::min(least, hull_distance(one, other));
  return least;
}

}  // namespace legwright
