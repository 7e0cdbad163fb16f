// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace legwright {

/// The way of a foot's sole through the air, from where it left the ground to where it comes down.
class FlightPath {
 public:
  void add(const Eigen::Vector3d& sole) { path_.push_back(sole); }
  void clear() { path_.clear(); }
  std::size_t size() const { return path_.size(); }

  /// How high a thin bar across the way may be, so that the sole passes over it, wherever in the
  /// middle half of the way it lies best [m]. Over a bar a sole passes as high as it is lowest
  /// where it crosses it, back and forth. Of a foot that comes down where it left, the highest
  /// point of its way. 0 for no way at all.
  double clearance() const;

 private:
  /// Lowest height where the sole crosses a share of the way. @param along share of the way at each
  /// moment
  double lowest_at(double share, const std::vector<double>& along) const;

  std::vector<Eigen::Vector3d> path_;  // world, ground at z = 0 [m]
};

}  // namespace legwright
