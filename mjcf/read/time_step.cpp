// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"

namespace legwright {
namespace {

constexpr double kUsualStep = 0.001, kShortestStep = 0.00025;  // [s]
constexpr double kMostDamped = 2.5;  // rate of a joint's damping times the step

/// At which the speed of a joint falls by what damps it [1/s].
double damping_rate(const Servo& servo) {
  return (servo.kd * servo.arm * servo.arm + servo.joint_damping) * servo.mobility;
}

}  // namespace

void read_mobility(const mjModel& model, const std::filesystem::path& file,
                   std::vector<Servo>& servos) {
  const DataPointer data = kinematics_at(model, home_qpos(model), file);
  mj_comPos(&model, data.get());
  mj_tendon(&model, data.get());  // one may have an armature
  mj_makeM(&model, data.get());
  mj_factorM(&model, data.get());
  std::vector<mjtNum> torque(static_cast<std::size_t>(model.nv)), acceleration(torque.size());
  for (Servo& servo : servos) {
    const int joint = mj_name2id(&model, mjOBJ_JOINT, servo.joint.c_str());
    const auto dof = static_cast<std::size_t>(model.jnt_dofadr[joint]);
    std::fill(torque.begin(), torque.end(), 0.0);
    torque[dof] = 1.0;
    mj_solveM(&model, data.get(), acceleration.data(), torque.data(), 1);
    servo.mobility = acceleration[dof];
  }
}

double step_of_scenes(const std::vector<Servo>& servos) {
  double fastest = 0.0;
  for (const Servo& servo : servos) fastest = std::max(fastest, damping_rate(servo));
  double step = kUsualStep;
  while (step > kShortestStep && fastest * step > kMostDamped) step /= 2.0;
  return step;
}

std::string describe_step(const std::vector<Servo>& servos) {
  const double step = step_of_scenes(servos);
  if (step == kUsualStep) return "";
  const Servo& fastest = *std::max_element(
      servos.begin(), servos.end(),
      [](const Servo& a, const Servo& b) { return damping_rate(a) < damping_rate(b); });
  return fmt::format(
      "scenes take steps of {:g} ms, not {:g} ms, as joint '{}' is light for what damps it ({:.2g} "
      "per s): MuJoCo needs {} times as long. If its motor has a rotor, write what that adds as "
      "armature= of the joint",
      1000 * step, 1000 * kUsualStep, fastest.joint, damping_rate(fastest), kUsualStep / step);
}

}  // namespace legwright
