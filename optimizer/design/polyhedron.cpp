// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/polyhedron.hpp"

#include <Eigen/Geometry>
#include <array>

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// ∫ z zᵀ over a tetrahedron of volume one, of what is affine in place: of its corners and their
/// mean.
template <class Vector>
auto mean_square(const std::array<Vector, 4>& corners) {
  const Vector sum = corners[0] + corners[1] + corners[2] + corners[3];
  auto out = (sum * sum.transpose()).eval();
  for (const Vector& corner : corners) out += corner * corner.transpose();
  return (out / 20.0).eval();
}

double volume_within(const std::array<Vector3d, 4>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) /
         6.0;
}

}  // namespace

SolidMoments moments_of_solid(const std::vector<Facet>& facets,
                              const std::vector<Vector3d>& points) {
  SolidMoments out;
  if (facets.empty()) return out;
  const Vector3d& base = points[static_cast<std::size_t>(facets.front()[0])];
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (const Facet& facet : facets) {
    std::array<Vector3d, 4> corners{Vector3d::Zero()};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k + 1] = points[static_cast<std::size_t>(facet[k])] - base;
    const double volume = volume_within(corners);
    out.volume += volume;
    first += volume / 4.0 * (corners[1] + corners[2] + corners[3]);
    second += volume * mean_square(corners);
  }
  const Vector3d centre = first / out.volume;
  out.centre = base + centre;
  out.second = second - out.volume * centre * centre.transpose();
  return out;
}

}  // namespace legwright
