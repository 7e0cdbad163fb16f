// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/flight_path.hpp"

#include <algorithm>
#include <limits>

namespace legwright {
namespace {

constexpr double kOnTheSpot = 2e-3;  // [m] shorter steps have no middle to speak of

}  // namespace

double FlightPath::clearance() const {
  if (path_.empty()) return 0.0;
  const Eigen::Vector2d from = path_.front().head<2>(), way = path_.back().head<2>() - from;
  if (way.norm() < kOnTheSpot) {
    double highest = 0.0;
    for (const Eigen::Vector3d& sole : path_) highest = std::max(highest, sole.z());
    return highest;
  }
  const auto share = [&](const Eigen::Vector3d& sole) {
    return (sole.head<2>() - from).dot(way) / way.squaredNorm();
  };
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < path_.size(); ++k) {
    const double before = share(path_[k - 1]) - 0.5, after = share(path_[k]) - 0.5;
    if ((before < 0.0) == (after < 0.0)) continue;
    const double at = before / (before - after);
    lowest = std::min(lowest, (1.0 - at) * path_[k - 1].z() + at * path_[k].z());
  }
  return std::max(0.0, lowest);  // it starts at 0 and ends at 1, so it crosses
}

}  // namespace legwright
