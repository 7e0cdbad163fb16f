// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/limited_motors.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

namespace {

constexpr double kLeast = 0.1;  // of a limit, where friction takes nearly all or more

/// What the motor has for others than the joint's dry friction, whichever way that acts.
double left_of_limit(const Joint& joint) {
  return std::max(joint.torque_limit - joint.friction_loss, kLeast * joint.torque_limit);
}

}  // namespace

std::vector<LimitedMotor> limited_motors(const Morphology& morphology, const Layout& layout) {
  std::vector<LimitedMotor> motors;
  for (int i = 0; i < layout.knot_count(); ++i)
    for (int a = 0; a < layout.joint_count(); ++a) {
      const Joint& joint = morphology.links[a + 1].joint;
      if (std::isfinite(joint.torque_limit) && joint.torque_limit > 0.0)
        motors.push_back({i, layout.joint_torque(i, a), left_of_limit(joint), joint.name});
    }
  return motors;
}

}  // namespace legwright
