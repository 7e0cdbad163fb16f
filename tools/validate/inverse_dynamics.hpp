// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/run/comparison_record.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {

/// What MuJoCo's own equations of motion say of a plan before anything is played, and of each foot.
struct PlanAgainstDynamics : InverseDynamics {
  std::vector<double> foot_roll;  // angle by which each foot's link rolls in a stance [rad]
  // Path of each foot's lowest point along the ground in a stance [m]: none where the plan rolls
  // its feet as a ball rolls.
  std::vector<double> foot_slip;
};

/// Residuals at each knot and at the centres of `bins` equal parts of the cycle, of which the means
/// are taken; forces at each knot. Throws MujocoError where MuJoCo has no memory.
PlanAgainstDynamics inverse_dynamics(const Scene& scene, int bins);

/// One line: "root residual 0.4 % of the weight (at phase 0.52), friction 0.31 of 0.80, …".
std::string describe(const InverseDynamics& dynamics);

}  // namespace legwright
