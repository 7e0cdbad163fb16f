// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "mjcf/assembly/module.hpp"

namespace legwright {

/// A shape of an outline as the hull of points, padded by a radius; round ones from outside. [m]
struct OutlineHull {
  std::vector<Eigen::Vector3d> points;
  double radius = 0.0;
};
using OutlineHulls = std::vector<OutlineHull>;

/// Every shape of a module's outline. @param pose of the module
OutlineHulls outline_hulls(const Module& module, const Eigen::Isometry3d& pose);

OutlineHulls moved(OutlineHulls hulls, const Eigen::Isometry3d& by);

/// Least distance [m]; zero where they touch or meet.
double hull_distance(const OutlineHull& a, const OutlineHull& b);
double hull_distance(const OutlineHulls& a, const OutlineHulls& b);

}  // namespace legwright
