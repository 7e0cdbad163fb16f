// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/tetrahedron_sum.hpp"

#include <Eigen/Geometry>

namespace legwright {
namespace {

using Eigen::Vector3d;
using Entries = TetrahedronSum::Entries;

/// Adds factor · (u vᵀ + v uᵀ)/2 to the entries of second order.
void add_product(double factor, const Vector3d& u, const Vector3d& v, Entries& to) {
  const double half = 0.5 * factor;
  to[0] += factor * (u[0] * v[0]);
  to[1] += factor * (u[1] * v[1]);
  to[2] += factor * (u[2] * v[2]);
  to[3] += half * (u[0] * v[1] + u[1] * v[0]);
  to[4] += half * (u[0] * v[2] + u[2] * v[0]);
  to[5] += half * (u[1] * v[2] + u[2] * v[1]);
}

double dot(const std::array<Vector3d, 3>& a, const std::array<Vector3d, 3>& b) {
  return a[0].dot(b[0]) + a[1].dot(b[1]) + a[2].dot(b[2]);
}

}  // namespace

TetrahedronSum::TetrahedronSum(const MovingPoints& points, bool volume_only)
    : points_(points),
      volume_only_(volume_only),
      slopes_(points.points.size()),
      second_(points.second.size(), Entries::Zero()),
      own_(points.first.size()) {}

// ∫ over a tetrahedron of volume one with the origin as a corner: second order (Σ c cᵀ + (Σ c)(Σ
// c)ᵀ)/20, first order Σ c/4.
TetrahedronSum::Tetrahedron TetrahedronSum::over(const Facet& facet) const {
  Tetrahedron at;
  at.sum.setZero();
  for (std::size_t i = 0; i < 3; ++i) {
    at.corners[i] = static_cast<std::size_t>(facet[i]);
    at.places[i] = points_.points[at.corners[i]];
    at.sum += at.places[i];
    at.ends |= points_.end_of[at.corners[i]];
  }
  for (std::size_t i = 0; i < 3; ++i)
    at.normals[i] = at.places[(i + 1) % 3].cross(at.places[(i + 2) % 3]);
  at.volume = at.places[0].dot(at.normals[0]) / 6.0;
  at.square.setZero();
  at.square[9] = 1.0;
  if (volume_only_) return at;
  for (std::size_t i = 0; i < 3; ++i)
    add_product(0.05, at.places[i] + at.sum, at.places[i], at.square);
  at.square.segment<3>(6) = 0.25 * at.sum;
  return at;
}

void TetrahedronSum::add(const Facet& facet) {
  const Tetrahedron at = over(facet);
  value_ += at.volume * at.square;
  const Entries by_volume = at.square / 6.0;
  for (std::size_t i = 0; i < 3; ++i) {
    PointSlope& own = slopes_[at.corners[i]];
    own.by_volume.noalias() += by_volume * at.normals[i].transpose();
    own.by_place += at.volume * (at.places[i] + at.sum);
    own.volume += at.volume;
  }
  add_pairs(at);
}

void TetrahedronSum::add_pairs(const Tetrahedron& at) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < points_.first.size(); ++k) {
    if (!(points_.first[k].ends & at.ends)) continue;
    Slope& a = own_[count++];
    fill(at, k, a);
    for (std::size_t i = 0; i < count; ++i) {
      const Slope& b = own_[i];
      Entries& to = second_[MovingPoints::pair(k, b.parameter)];
      to += dot(a.steps, b.normals) / 6.0 * at.square;
      if (volume_only_) continue;
      to += a.volume * b.square + b.volume * a.square;
      for (std::size_t j = 0; j < 3; ++j) add_product(0.1 * at.volume, a.steps[j], b.steps[j], to);
      add_product(0.1 * at.volume, a.sum, b.sum, to);
    }
  }
}

void TetrahedronSum::fill(const Tetrahedron& at, std::size_t k, Slope& out) const {
  out.parameter = k;
  for (std::size_t i = 0; i < 3; ++i) out.steps[i] = points_.first[k].steps[at.corners[i]];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, n = (i + 2) % 3;
    out.normals[i] = out.steps[j].cross(at.places[n]) + at.places[j].cross(out.steps[n]);
  }
  if (volume_only_) return;
  out.volume = dot(out.steps, at.normals) / 6.0;
  out.sum = out.steps[0] + out.steps[1] + out.steps[2];
  out.square.setZero();
  for (std::size_t i = 0; i < 3; ++i)
    add_product(0.1, at.places[i] + at.sum, out.steps[i], out.square);
  out.square.segment<3>(6) = 0.25 * out.sum;
}

Entries TetrahedronSum::along(const MovingPoints::Moves& moves) const {
  Entries out = Entries::Zero();
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    if (!(moves.ends & points_.end_of[i])) continue;
    const PointSlope& own = slopes_[i];
    const Vector3d& step = moves.steps[i];
    out.noalias() += own.by_volume * step;
    if (volume_only_) continue;
    add_product(0.1, own.by_place, step, out);
    out.segment<3>(6) += 0.25 * own.volume * step;
  }
  return out;
}

Entries TetrahedronSum::second(std::size_t k, std::size_t l) const {
  return second_[MovingPoints::pair(k, l)] + along(points_.second[MovingPoints::pair(k, l)]);
}

}  // namespace legwright
