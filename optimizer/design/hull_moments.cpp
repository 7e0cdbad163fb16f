// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/hull_moments.hpp"

#include <set>

#include "optimizer/design/moving_points.hpp"
#include "optimizer/design/tetrahedron_sum.hpp"

namespace legwright {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Matrix4d matrix_of(const TetrahedronSum::Entries& m) {
  Matrix4d out;
  out << m[0], m[3], m[4], m[6],  //
      m[3], m[1], m[5], m[7],     //
      m[4], m[5], m[2], m[8],     //
      m[6], m[7], m[8], m[9];
  return out;
}

HullMoments moments_at(const HullPart& hull, const VectorXd& s, bool volume_only) {
  HullMoments out;
  out.parameters = hull_parameters(hull);
  const MovingPoints points(hull, out.parameters, s);
  TetrahedronSum sum(points, volume_only);
  for (const Facet& facet : hull_facets(hull, points.points)) sum.add(facet);
  const std::size_t n = out.parameters.size();
  out.moments = matrix_of(sum.value());
  out.second.assign(n, std::vector<Matrix4d>(n));
  for (std::size_t k = 0; k < n; ++k) {
    out.first.push_back(matrix_of(sum.first(k)));
    for (std::size_t l = 0; l <= k; ++l)
      out.second[k][l] = out.second[l][k] = matrix_of(sum.second(k, l));
  }
  return out;
}

}  // namespace

std::vector<int> hull_parameters(const HullPart& hull) {
  std::set<int> found;
  for (const HullPart::End& end : hull.ends) {
    for (const AffineVector::Slope& slope : end.origin.slopes)
      if (!slope.slope.isZero(0.0)) found.insert(slope.parameter);
    for (const TurnedVector::Turn& turn : end.turns) found.insert(turn.parameter);
  }
  return {found.begin(), found.end()};
}

std::vector<Vector3d> hull_points(const HullPart& hull, const VectorXd& s) {
  return MovingPoints(hull, hull_parameters(hull), s).points;
}

std::vector<Facet> hull_facets(const HullPart& hull, const std::vector<Vector3d>& points) {
  return is_convex_hull(hull.facets, points) ? hull.facets : convex_hull(points);
}

HullMoments hull_moments(const HullPart& hull, const VectorXd& s) {
  return moments_at(hull, s, false);
}

HullMoments hull_volume(const HullPart& hull, const VectorXd& s) {
  return moments_at(hull, s, true);
}

}  // namespace legwright
