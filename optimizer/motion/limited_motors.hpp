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

/// All of them, knot by knot; motors without a limit are left out.
std::vector<LimitedMotor> limited_motors(const Morphology& morphology, const Layout& layout);

}  // namespace legwright
