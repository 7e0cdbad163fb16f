// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// Compares two robots, each at its own design: names and tree, link origins, orientations, axes,
/// feet, ends of linear actuators, and mass, centre and second moments of each link. Lengths and
/// second moments relative to the size of the robot and of the link. Returns the first difference
/// above the tolerance in words, empty if there is none.
std::string find_difference(const Morphology& a, const Eigen::VectorXd& s_a, const Morphology& b,
                            const Eigen::VectorXd& s_b, double tolerance = 1e-9);

}  // namespace legwright
