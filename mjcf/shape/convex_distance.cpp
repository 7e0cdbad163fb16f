// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/convex_distance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr int kMostSupports = 100;
constexpr double kNearEnough = 1e-10;    // of the size
constexpr double kFlatTriangle = 1e-15;  // of the product of the edges' squares

/// The point of a list that lies farthest in a direction.
const Vector3d& farthest_along(const std::vector<Vector3d>& points, const Vector3d& direction) {
  const Vector3d* farthest = &points.front();
  double most = farthest->dot(direction);
  for (const Vector3d& each : points) {
    const double along = each.dot(direction);
    if (!(most < along)) continue;
    most = along;
    farthest = &each;
  }
  return *farthest;
}

/// Up to four corners.
class Simplex {
 public:
  void add(const Vector3d& corner) { corners_[count_++] = corner; }
  std::size_t size() const { return count_; }
  const Vector3d& operator[](std::size_t k) const { return corners_[k]; }
  bool has(const Vector3d& corner) const {
    return std::find(corners_.begin(), corners_.begin() + count_, corner) !=
           corners_.begin() + count_;
  }

 private:
  std::array<Vector3d, 4> corners_;
  std::size_t count_ = 0;
};

/// The point of the space that N edges from the first of N + 1 corners span that is nearest to the
/// origin, if it lies between all of them.
template <int N>
bool nearest_by_edges(const Simplex& corners, Vector3d& nearest) {
  Eigen::Matrix<double, 3, N> edges;
  for (int k = 0; k < N; ++k) edges.col(k) = corners[static_cast<std::size_t>(k) + 1] - corners[0];
  using Square = Eigen::Matrix<double, N, N>;
  const Square square = edges.transpose() * edges;
  Square inverse;
  double determinant = 0.0;
  bool spans_it = false;
  square.computeInverseAndDetWithCheck(inverse, determinant, spans_it,
                                       kFlatTriangle * square.diagonal().prod());
  if (!spans_it) return false;
  const Eigen::Matrix<double, N, 1> shares = inverse * (edges.transpose() * -corners[0]);
  if (shares.minCoeff() < 0.0 || shares.sum() > 1.0) return false;
  nearest = corners[0] + edges * shares;
  return true;
}

/// The point of the solid, plane, line or point through some corners that is nearest to the origin,
/// if it lies between all of them.
bool nearest_between(const Simplex& corners, Vector3d& nearest) {
  switch (corners.size()) {
    case 1:
      nearest = corners[0];
      return true;
    case 2:
      return nearest_by_edges<1>(corners, nearest);
    case 3:
      return nearest_by_edges<2>(corners, nearest);
    default:
      return nearest_by_edges<3>(corners, nearest);
  }
}

/// Adds a corner to a simplex between whose corners `nearest` lies, and keeps those between which
/// the nearest point to the origin lies now. False if none is nearer.
bool add_and_reduce(const Vector3d& corner, Simplex& simplex, Vector3d& nearest) {
  const unsigned old_sets = 1U << simplex.size();  // without the new corner none is nearer
  Simplex kept;
  double least = nearest.norm();
  for (unsigned set = 0; set < old_sets; ++set) {
    Simplex some;
    for (std::size_t k = 0; k < simplex.size(); ++k)
      if (set >> k & 1U) some.add(simplex[k]);
    some.add(corner);
    Vector3d found;
    if (!nearest_between(some, found) || !(found.norm() < least)) continue;
    least = found.norm();
    nearest = found;
    kept = some;
  }
  if (kept.size() == 0) return false;
  simplex = kept;
  return true;
}

}  // namespace

double convex_distance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  Vector3d nearest = a.front() - b.front();
  Simplex simplex;
  simplex.add(nearest);
  for (int round = 0; round < kMostSupports; ++round) {
    const double distance = nearest.norm();
    const Vector3d corner = farthest_along(a, -nearest) - farthest_along(b, nearest);
    // No corner is nearer along this direction: it is the least distance.
    const double least = distance > 0.0 ? nearest.dot(corner) / distance : 0.0;
    if (!(distance - least > kNearEnough * (distance + corner.norm()))) return distance;
    if (simplex.has(corner) || !add_and_reduce(corner, simplex, nearest)) return distance;
    if (simplex.size() == 4) return 0.0;  // the origin lies within
  }
  return nearest.norm();
}

}  // namespace legwright
