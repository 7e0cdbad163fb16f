// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/limited_motors.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

namespace {

constexpr double kLeast = 0.1;  // of a limit, where friction takes nearly all or more

/// What a motor has for others than the joint's dry friction, whichever way that acts.
double left_of(double torque, const Joint& joint) {
  return std::max(torque - joint.friction_loss, kLeast * torque);
}

}  // namespace

std::vector<LimitedMotor> limited_motors(const Morphology& morphology, const Layout& layout) {
  std::vector<LimitedMotor> motors;
  for (int i = 0; i < layout.knot_count(); ++i)
    for (int a = 0; a < layout.joint_count(); ++a) {
      const Joint& joint = morphology.links[a + 1].joint;
      if (std::isfinite(joint.torque_limit) && joint.torque_limit > 0.0)
        motors.push_back(
            {i, layout.joint_torque(i, a), left_of(joint.torque_limit, joint), joint.name});
    }
  return motors;
}

std::vector<MotorAtSpeed> motors_at_speed(const Morphology& morphology, const Layout& layout) {
  std::vector<MotorAtSpeed> motors;
  const auto is_linear = [&](int a) {
    return std::any_of(morphology.linear_actuators.begin(), morphology.linear_actuators.end(),
                       [&](const LinearActuator& each) { return each.joint == a; });
  };
  for (int i = 0; i < layout.knot_count(); ++i)
    for (int a = 0; a < layout.joint_count(); ++a) {
      const Joint& joint = morphology.links[a + 1].joint;
      if (!joint.line || is_linear(a)) continue;
      const int before = i > 0 ? i - 1 : layout.knot_count() - 1;
      motors.push_back({i, layout.joint_torque(i, a), layout.pose(before) + 6 + a,
                        layout.pose(i + 1) + 6 + a, left_of(joint.line->stall_torque, joint),
                        joint.line->no_load_speed, joint.name});
    }
  return motors;
}

}  // namespace legwright
