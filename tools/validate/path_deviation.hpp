// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace legwright {

/// The greatest distance of any of the points from the wanted path [m]: the straight line, or the
/// arc of a robot that turns, which leaves the first point. How far along it they are does not
/// count.
/// @param points on the ground, world [m] @param velocity forward, left in the heading frame [m/s];
/// not zero @param turn_rate [rad/s] @param heading at the first point [rad]
double distance_from_path(const std::vector<Eigen::Vector2d>& points,
                          const Eigen::Vector2d& velocity, double turn_rate, double heading = 0.0);

}  // namespace legwright
