// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// Forces of stance feet against gravity that carry the weight without tipping the robot about its
/// COM, the smallest in the sense of least squares, none below `least` [N].
/// @param com along gravity on the ground @param length that makes levers dimensionless [m]
std::vector<double> shares_of_weight(const Eigen::Vector3d& com,
                                     const std::vector<Eigen::Vector3d>& stance, double weight,
                                     double length, double least);

/// Torque of each joint's motor that stands still in the home pose on all feet, trunk level [N m].
Eigen::VectorXd standing_torques(const Morphology& morphology, const Eigen::VectorXd& s);

}  // namespace legwright
