// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace legwright {

/// Least distance between the convex hulls of two lists of points [m]; zero where they touch or
/// meet. To a billionth of their size (the algorithm of Gilbert, Johnson and Keerthi, 1988).
double convex_distance(const std::vector<Eigen::Vector3d>& a,
                       const std::vector<Eigen::Vector3d>& b);

}  // namespace legwright
