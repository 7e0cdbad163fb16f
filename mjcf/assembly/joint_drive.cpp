// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/joint_drive.hpp"

#include <algorithm>
#include <cmath>

#include "mjcf/assembly/linear_joint.hpp"
#include "mjcf/assembly/reflected_inertia.hpp"
#include "mjcf/read/robot_model.hpp"

namespace legwright {

DriveGains drive_gains(const AssemblyJoint& joint, const Assembly& assembly) {
  const double limit = torque_limit(assembly, joint.servo);
  if (!joint.is_linear()) {
    const double kp = joint.servo.joint->kp.value_or(limit / kFullTorqueError);
    return {kp, joint.servo.joint->kd.value_or(kDampingTime * kp)};
  }
  const ModuleSlide& slide = *joint.servo.slide;
  const double arm = std::abs(moment_arm_at(joint, 0.0)),
               kp = slide.kp.value_or(limit / (kFullTorqueError * arm)),
               mass = armature_of(joint, assembly).value_or(0.0) / (arm * arm);
  return {kp, slide.kd.value_or(std::max(kDampingTime * kp, std::sqrt(kp * mass)))};
}

std::optional<std::array<double, 2>> drive_range(const AssemblyJoint& joint) {
  if (joint.is_linear()) return linear_range(joint);
  return joint.range ? joint.range : joint.servo.joint->range;
}

std::optional<MotorLine> drive_line(const Module& servo) {
  if (servo.slide && servo.slide->no_load_speed)
    return MotorLine{servo.slide->line_force(), *servo.slide->no_load_speed};
  if (servo.joint && servo.joint->no_load_speed)
    return MotorLine{servo.joint->stall_torque, *servo.joint->no_load_speed};
  return std::nullopt;
}

}  // namespace legwright
