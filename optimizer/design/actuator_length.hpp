// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// How the length of a linear actuator depends on its hinge's angle q:
///   L² = A + B cos q + C sin q,
/// because one end moves on a circle about the axis. With w the vector from the upper end to the
/// hinge and l the one from the hinge to the lower end, both in the link's frame at q = 0, and a
/// the axis:
/// in units of the leg length, so that all derived quantities are of size one:
///   A = w² + l² + 2 (w·a)(l·a),  B = 2 w·l − 2 (w·a)(l·a),  C = 2 w·(a × l).
/// A, B, C are functions of the design; here with exact first and second derivatives.
struct ActuatorShape {
  Eigen::Vector3d value;                 // A, B, C [leg length²]
  std::vector<int> parameters;           // of s, rising
  Eigen::Matrix3Xd jacobian;             // 3 × parameters
  std::vector<Eigen::MatrixXd> hessian;  // of A, B, C; parameters × parameters
};

/// Parameters that an actuator's length depends on, rising.
std::vector<int> actuator_parameters(const Morphology& morphology, const LinearActuator& actuator);
ActuatorShape actuator_shape(const Morphology& morphology, const LinearActuator& actuator,
                             const Eigen::VectorXd& s);

/// L [leg length] of a shape at angle q.
double actuator_length(const Eigen::Vector3d& shape, double q);
/// Moment arm ∂L/∂q [leg length]: the joint's torque over the actuator's force.
double moment_arm(const Eigen::Vector3d& shape, double q);

}  // namespace legwright
