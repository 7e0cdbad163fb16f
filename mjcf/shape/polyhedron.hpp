// SPDX-License-Identifier: Apache-2.0
// What a solid within triangles weighs, as it is and as its corners move with a design.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mjcf/shape/convex_hull.hpp"
#include "optimizer/design/morphology.hpp"

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

/// The same solid as point masses whose moments are its own for every design, while its corners
/// move with the design and its triangles stay: polynomials of the lengths, as each tetrahedron's
/// volume is affine in each. Some masses are negative; the sum and the moments are what counts. As
/// many for the same lengths, whatever the solid.
/// @param points affine in the design; what one parameter moves, it moves along one direction
/// @param density [kg/m3]. @param initial the design, with no zero among its lengths
std::vector<PointMass> masses_of_solid(const std::vector<Facet>& facets,
                                       const std::vector<AffineVector>& points, double density,
                                       const Eigen::VectorXd& initial);

}  // namespace legwright
