// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/flight_path.hpp"

#include <algorithm>
#include <limits>

namespace legwright {
namespace {

constexpr int kBars = 50;            // places that are tried for a bar, less one
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
  std::vector<double> along;
  for (const Eigen::Vector3d& sole : path_)
    along.push_back((sole.head<2>() - from).dot(way) / way.squaredNorm());
  double best = 0.0;
  for (int k = 0; k <= kBars; ++k)
    best = std::max(best, lowest_at(0.25 + 0.5 * static_cast<double>(k) / kBars, along));
  return best;
}

double FlightPath::lowest_at(double share, const std::vector<double>& along) const {
  double lowest = std::numeric_limits<double>::infinity();  // from 0 to 1 it must cross
  for (std::size_t k = 1; k < path_.size(); ++k) {
    const double before = along[k - 1] - share, after = along[k] - share;
    if ((before < 0.0) == (after < 0.0)) continue;
    const double at = before / (before - after);
    lowest = std::min(lowest, (1.0 - at) * path_[k - 1].z() + at * path_[k].z());
  }
  return lowest;
}

}  // namespace legwright
