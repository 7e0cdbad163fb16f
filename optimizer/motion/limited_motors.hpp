// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/layout.hpp"

namespace legwright {

/// A motor with a torque limit, at a knot.
struct LimitedMotor {
  int knot;
  int slot;      // of its torque by inverse dynamics (Layout::joint_torque)
  double limit;  // less the joint's dry friction [N m], finite and positive
  std::string name;
};

/// A motor whose torque falls with speed (MotorLine), at a knot. Its joint's speed is the
/// difference of the angles of the knots beside it, over two time steps.
struct MotorAtSpeed {
  int knot;
  int torque_slot, before_slot, after_slot;
  double stall_torque;   // less the joint's dry friction [N m]
  double no_load_speed;  // [rad/s]
  std::string name;
};

/// All that have a line and turn their joint themselves, knot by knot.
std::vector<MotorAtSpeed> motors_at_speed(const Morphology& morphology, const Layout& layout);

/// All of them, knot by knot; motors without a limit are left out.
std::vector<LimitedMotor> limited_motors(const Morphology& morphology, const Layout& layout);

}  // namespace legwright
