// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace legwright {

/// Corners of a triangle, counter-clockwise as seen from outside: indices into a list of points.
using Facet = std::array<int, 3>;

/// The convex hull of points as triangles, which make up a closed surface. Points within it, and
/// those nearer to it than a billionth of its size, are no corners. The same points in the same
/// order give the same triangles, in the same order. Quickhull (Barber, Dobkin and Huhdanpaa,
/// 1996). Empty where the points lie in one plane, to a billionth of how far they are spread.
/// @param points [m]; the memory is of the square of their number
std::vector<Facet> convex_hull(const std::vector<Eigen::Vector3d>& points);

/// Whether a closed surface that was the hull of points still is, after they moved: no point lies
/// outside of a triangle's plane by more than the tolerance of convex_hull().
bool is_convex_hull(const std::vector<Facet>& facets, const std::vector<Eigen::Vector3d>& points);

/// The points that are corners of a surface, in their order.
std::vector<int> corners_of(const std::vector<Facet>& facets);

}  // namespace legwright
