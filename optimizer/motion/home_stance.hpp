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
  /// ∂footprint/∂s per foot, 2 × design size; empty where the design does not move it.
  std::vector<Eigen::Matrix2Xd> footprint_slopes = {};
};

/// The robot standing in its home pose at the design s: COM and feet under a level trunk.
StyleTargets home_stance(const Morphology& morphology, const Eigen::VectorXd& s);

/// How the design moves the hips on the ground under a level trunk, as seen from the middle of all
/// hips: ∂hip/∂s per foot, 2 × size of s, the same at every design. The hip of a foot is the first
/// hinge below the trunk that carries no other foot. Joints that several feet share stand as in the
/// home pose of the design `initial`; turns of their axes do not count.
std::vector<Eigen::Matrix2Xd> hip_slopes(const Morphology& morphology,
                                         const Eigen::VectorXd& initial);

}  // namespace legwright
