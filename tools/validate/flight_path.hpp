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

  /// How high a thin bar may be that lies halfway across the way, so that the sole passes over it [m]: the lowest
  /// height of the sole where it crosses the middle. Of a foot that comes down where it left, the highest point of its
  /// way. 0 for no way at all.
  double clearance() const;

 private:
  std::vector<Eigen::Vector3d> path_;  // world, ground at z = 0 [m]
};

}  // namespace legwright
