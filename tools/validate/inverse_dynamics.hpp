// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "tools/simulate/scene.hpp"

namespace legwright {

/// What MuJoCo's own equations of motion say of a plan before anything is played: how much force
/// and torque the played motion needs at the trunk beyond gravity and planned contact forces, where
/// nothing can give it, and how near the contact forces come to their limits. Phases are shares of
/// the period.
struct InverseDynamics {
  double force_max = 0.0, force_rms = 0.0;    // residual force, share of the weight
  double torque_max = 0.0, torque_rms = 0.0;  // residual torque, share of weight × trunk height
  double worst_phase = 0.0;                   // of the residual force
  Eigen::VectorXd force;                      // residual at the bins' centres, share of the weight

  double friction_max = 0.0;  // tangential over normal planned force
  double friction_coefficient = 0.0;
  std::string friction_foot;
  double friction_phase = 0.0;
  double normal_min = 0.0;        // [N], of feet that the plan has on the ground
  double normal_min_share = 0.0;  // of the weight
  std::string normal_foot;
  double normal_phase = 0.0;

  std::vector<double> foot_roll;  // angle by which each foot's link rolls in a stance [rad]
  // Path of each foot's lowest point along the ground in a stance [m]: none where the plan rolls
  // its feet as a ball rolls.
  std::vector<double> foot_slip;
};

/// Residuals at each knot and at the centres of `bins` equal parts of the cycle, of which the means
/// are taken; forces at each knot. Throws MujocoError where MuJoCo has no memory.
InverseDynamics inverse_dynamics(const Scene& scene, int bins);

/// One line: "root residual 0.4 % of the weight (at phase 0.52), friction 0.31 of 0.80, …".
std::string describe(const InverseDynamics& dynamics);

}  // namespace legwright
