// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// What eqs (10) and the swing want where the task gives no lists over the cycle.
struct StyleTargets {
  double com_height = 0.0;                 // [m]
  std::vector<Eigen::Vector2d> footprint;  // foot − COM on the ground at heading zero, per foot [m]
  double swing_height = 0.0;               // [m]; 0 of a home stance
};

/// The robot standing in its home pose at the design s: COM and feet under a level trunk.
StyleTargets home_stance(const Morphology& morphology, const Eigen::VectorXd& s);

}  // namespace legwright
