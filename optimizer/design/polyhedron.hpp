// SPDX-License-Identifier: Apache-2.0
// What a solid within triangles weighs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/convex_hull.hpp"

namespace legwright {

/// A body of density one.
struct SolidMoments {
  double volume = 0.0;                               // [m3]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m]
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // ∫ r rᵀ about the centre [m5]
  /// About the centre [m5].
  Eigen::Matrix3d inertia() const { return second.trace() * Eigen::Matrix3d::Identity() - second; }
};

/// Volume, centre and second moments of the solid within a closed surface, exactly: sums over the
/// tetrahedra from one corner to each triangle.
SolidMoments moments_of_solid(const std::vector<Facet>& facets,
                              const std::vector<Eigen::Vector3d>& points);

}  // namespace legwright
