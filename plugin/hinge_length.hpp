// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

namespace legwright {

/// Length of a linear actuator (a tendon between two sites) as a function of the one hinge that it
/// spans: L² = a + b cos q + c sin q, because one end moves on a circle about the hinge.
struct HingeLength {
  int joint = -1;                    // MuJoCo's
  double a = 0.0, b = 0.0, c = 0.0;  // [m²]

  double length(double q) const noexcept;  // [m]
  double arm(double q) const noexcept;     // ∂L/∂q [m]
};

/// Reads the tendon's sites and its hinge from the model. Throws std::invalid_argument, with the
/// reason, where it is not a spatial tendon between two sites on either side of one hinge.
HingeLength hinge_length(const mjModel* m, int tendon);

}  // namespace legwright
