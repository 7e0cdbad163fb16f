// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/servo_gait.hpp"

#include "plugin/spline.hpp"

namespace legwright {
namespace {

/// The actuator that moves a joint of the plan. The plugin has refused a scene without one.
int actuator_of(const Scene& scene, std::size_t joint) {
  if (scene.tendon_actuator[joint] >= 0) return scene.tendon_actuator[joint];
  const mjModel& model = *scene.model;
  for (int a = 0; a < model.nu; ++a) {
    const int type = model.actuator_trntype[a];
    const bool on_joint = type == mjTRN_JOINT || type == mjTRN_JOINTINPARENT;
    const int* const moved = model.actuator_trnid + static_cast<std::ptrdiff_t>(2) * a;
    if (on_joint && *moved == scene.joints.joint[joint]) return a;
  }
  throw MujocoError(scene.name + ": joint '" + scene.trajectory.joint_names[joint] +
                    "' of the gait has no actuator");
}

}  // namespace

SceneServo servo_of(const Scene& scene, std::size_t joint) {
  const mjModel& model = *scene.model;
  SceneServo servo;
  servo.actuator = actuator_of(scene, joint);
  const mjtNum* const bias =
      model.actuator_biasprm + static_cast<std::ptrdiff_t>(mjNBIAS) * servo.actuator;
  servo.kp = -bias[1];
  servo.kd = -bias[2];
  servo.linear = scene.tendon_actuator[joint] >= 0;
  servo.limit = servo.linear && model.actuator_forcelimited[servo.actuator]
                    ? model.actuator_forcerange[static_cast<std::ptrdiff_t>(2) * servo.actuator + 1]
                    : scene.torque_limit[joint];
  return servo;
}

ServoGait::ServoGait(const Scene& scene)
    : timestep(scene.model->opt.timestep),
      gain_scale(scene.gain_scale),
      joints(scene.joints.joint),
      trajectory_(scene.trajectory),
      start_(scene.t0) {
  for (std::size_t joint = 0; joint < joints.size(); ++joint)
    servos.push_back(servo_of(scene, joint));
}

ServoCommand ServoGait::command(double time) const {
  const SplinePhase phase = phase_at(trajectory_, time + start_);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(trajectory_.joint_count());
  ServoCommand out{none, none, none};
  for (int k = 0; k < trajectory_.joint_count(); ++k) {
    const SplinePoint point = spline_point(trajectory_, phase, trajectory_.target_column(k));
    out.target[k] = point.value;
    out.velocity[k] = point.rate;
    out.torque[k] = linear_value(trajectory_, phase, trajectory_.torque_column(k));
  }
  return out;
}

}  // namespace legwright
