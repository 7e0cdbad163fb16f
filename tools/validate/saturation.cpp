// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/saturation.hpp"

#include <cmath>
#include <cstddef>

namespace legwright {
namespace {

constexpr double kShare = 0.9999;  // of the limit: MuJoCo clamps to it exactly

bool pulls_its_most(const mjModel& model, const mjData& data, int actuator) {
  if (actuator < 0 || !model.actuator_forcelimited[actuator]) return false;
  const mjtNum* range = model.actuator_forcerange + std::ptrdiff_t{2} * actuator;
  const double force = data.actuator_force[model.actuator_outadr[actuator]];
  return force <= kShare * range[0] || force >= kShare * range[1];
}

/// Whether a motor has nothing left at its speed.
bool is_at_its_line(const MotorLine& line, double torque, double velocity) {
  if (line.no_load_speed == 0.0) return false;
  const double share = velocity / line.no_load_speed;
  return torque >= line.stall_torque * (kShare - share) ||
         torque <= -line.stall_torque * (kShare + share);
}

}  // namespace

bool is_saturated(const Scene& scene, const mjData& data, std::size_t joint) {
  const int dof = scene.joints.dof[joint], rod = scene.tendon_actuator[joint];
  const double torque = data.qfrc_actuator[dof];
  if (std::abs(torque) >= kShare * scene.torque_limit[joint]) return true;
  if (rod < 0) return is_at_its_line(scene.motor_line[joint], torque, data.qvel[dof]);
  const int output = scene.model->actuator_outadr[rod];
  return is_at_its_line(scene.motor_line[joint], data.actuator_force[output],
                        data.actuator_velocity[output]) ||
         pulls_its_most(*scene.model, data, rod);
}

}  // namespace legwright
