// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/limited_motors.hpp"

#include <cmath>

namespace legwright {

std::vector<LimitedMotor> limited_motors(const Morphology& morphology, const Layout& layout) {
  std::vector<LimitedMotor> motors;
  for (int i = 0; i < layout.knot_count(); ++i)
    for (int a = 0; a < layout.joint_count(); ++a) {
      const Joint& joint = morphology.links[a + 1].joint;
      if (std::isfinite(joint.torque_limit) && joint.torque_limit > 0.0)
        motors.push_back({i, layout.joint_torque(i, a), joint.torque_limit, joint.name});
    }
  return motors;
}

}  // namespace legwright
