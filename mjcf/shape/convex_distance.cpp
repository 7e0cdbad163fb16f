// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/convex_distance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr int kMostSupports = 100;
constexpr double kNearEnough = 1e-10;  // of the size

/// The point of a list that lies farthest in a direction.
const Vector3d& farthest_along(const std::vector<Vector3d>& points, const Vector3d& direction) {
  return *std::max_element(points.begin(), points.end(), [&](const Vector3d& a, const Vector3d& b) {
    return a.dot(direction) < b.dot(direction);
  });
}

/// The point of the plane, line or point through some corners that is nearest to the origin, if it
/// lies between all of them.
bool nearest_between(const std::vector<Vector3d>& corners, Vector3d& nearest) {
  const auto count = static_cast<Eigen::Index>(corners.size()) - 1;
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, count);
  for (Eigen::Index k = 0; k < count; ++k)
    edges.col(k) = corners[static_cast<std::size_t>(k) + 1] - corners[0];
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
  const Square square = edges.transpose() * edges;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> shares(count);
  if (count > 0) {
    const Eigen::FullPivLU<Square> factors(square);
    if (!factors.isInvertible()) return false;
    shares = factors.solve(-edges.transpose() * corners[0]);
  }
  if (count > 0 && (shares.minCoeff() < 0.0 || shares.sum() > 1.0)) return false;
  nearest = corners[0] + edges * shares;
  return true;
}

/// Keeps those corners of a simplex between which its nearest point to the origin lies.
Vector3d nearest_of(std::vector<Vector3d>& simplex) {
  Vector3d best = simplex.front();
  std::vector<Vector3d> kept{simplex.front()};
  double least = std::numeric_limits<double>::infinity();
  for (unsigned set = 1; set < (1U << simplex.size()); ++set) {
    std::vector<Vector3d> some;
    for (std::size_t k = 0; k < simplex.size(); ++k)
      if (set >> k & 1U) some.push_back(simplex[k]);
    Vector3d nearest;
    if (!nearest_between(some, nearest) || !(nearest.norm() < least)) continue;
    least = nearest.norm();
    best = nearest;
    kept = std::move(some);
  }
  simplex = std::move(kept);
  return best;
}

}  // namespace

double convex_distance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  Vector3d nearest = a.front() - b.front();
  std::vector<Vector3d> simplex{nearest};
  for (int round = 0; round < kMostSupports; ++round) {
    const double distance = nearest.norm();
    const Vector3d corner = farthest_along(a, -nearest) - farthest_along(b, nearest);
    // No corner is nearer along this direction: it is the least distance.
    const double least = distance > 0.0 ? nearest.dot(corner) / distance : 0.0;
    if (!(distance - least > kNearEnough * (distance + corner.norm()))) return distance;
    if (std::find(simplex.begin(), simplex.end(), corner) != simplex.end()) return distance;
    simplex.push_back(corner);
    nearest = nearest_of(simplex);
    if (simplex.size() == 4) return 0.0;  // the origin lies within
  }
  return nearest.norm();
}

}  // namespace legwright
