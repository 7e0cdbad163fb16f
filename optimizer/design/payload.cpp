// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/payload.hpp"

#include <cmath>

namespace legwright {

std::vector<PointMass> point_masses(const Payload& payload) {
  // A box has Σ m x² = mass · (edge/2)²/3 along each edge: points at (edge/2)/√3 from its centre.
  const Eigen::Vector3d arm = payload.size / (2.0 * std::sqrt(3.0));
  std::vector<PointMass> points;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d place = payload.position;
    for (int c = 0; c < 3; ++c) place[c] += ((corner >> c) & 1) != 0 ? arm[c] : -arm[c];
    points.push_back({payload.mass / 8.0, {place, {}}});
  }
  return points;
}

double water_cube(double mass) { return std::cbrt(mass / 1000.0); }

}  // namespace legwright
