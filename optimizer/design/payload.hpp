// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// A box of even density that a robot carries, fixed to its trunk, its edges along the trunk's
/// axes. Frame of the trunk.
struct Payload {
  double mass = 0.0;                                   // [kg], > 0
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of its centre [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();      // whole edges [m]
};

/// Eight equal point masses with the mass, centre and inertia of the box.
std::vector<PointMass> point_masses(const Payload& payload);

/// Edge of a cube of that mass with the density of water [m].
double water_cube(double mass);

}  // namespace legwright
