// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/path_deviation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace legwright {

double distance_from_path(const std::vector<Eigen::Vector2d>& points,
                          const Eigen::Vector2d& velocity, double turn_rate, double heading) {
  double out = 0.0;
  if (points.empty()) return out;
  const Eigen::Vector2d ahead = Eigen::Rotation2Dd(heading) * velocity.normalized();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const double curvature = turn_rate / velocity.norm();  // of the arc, positive to the left [1/m]
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d way = point - points.front();
    // |p − centre| − radius, written so that it becomes p·left as the curvature vanishes.
    const double across = way.dot(left), bent = curvature * way.squaredNorm();
    const double root = 1.0 - 2.0 * curvature * across + curvature * bent;
    out = std::max(out, std::abs(2.0 * across - bent) / (1.0 + std::sqrt(std::max(root, 0.0))));
  }
  return out;
}

}  // namespace legwright
