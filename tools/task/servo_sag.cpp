// SPDX-License-Identifier: Apache-2.0
#include "tools/task/servo_sag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/scene/surroundings.hpp"
#include "optimizer/motion/standing.hpp"

namespace legwright {

double two_digits_up(double least) {
  const int power = static_cast<int>(std::floor(std::log10(least))) - 1;
  const double digits = std::ceil(least / std::pow(10.0, power) - 1e-9);
  return power < 0 ? digits / std::pow(10.0, -power) : digits * std::pow(10.0, power);
}

double ServoSag::stiff_kp() const { return two_digits_up(torque / kFirmSag); }

bool ServoSag::can_be_stiffer() const {
  return std::min(stiff_kp(), limit / kFullTorqueError) > 1.001 * kp;
}

ServoSag servo_sag(const RobotModel& robot) {
  const Eigen::VectorXd torques = standing_torques(robot.morphology, robot.space.initial());
  ServoSag sag;
  for (std::size_t a = 0; a < robot.servos.size(); ++a) {
    const Servo& servo = robot.servos[a];
    if (!servo.tendon.empty()) continue;
    const double torque = std::abs(torques[static_cast<Eigen::Index>(a)]);
    sag.torque = std::max(sag.torque, torque);
    const StandingLoad& most = sag.hardest;
    if (std::isfinite(servo.torque_limit) &&
        (most.joint.empty() || torque * most.limit > most.load * servo.torque_limit))
      sag.hardest = {servo.joint, torque, servo.torque_limit};
    if (!sag.joint.empty() && torque / servo.kp <= sag.angle) continue;
    sag.joint = servo.joint;
    sag.angle = torque / servo.kp;
    sag.kp = servo.kp;
    sag.load = torque;
    sag.limit = servo.torque_limit;
  }
  return sag;
}

ServoSag servo_sag(const RobotModel& robot, const Task& task) {
  return servo_sag(as_played(robot, task));
}

std::string weak_motors_text(const StandingLoad& standing) {
  if (standing.holds()) return "";
  return fmt::format(
      "motors too weak to stand: the home pose takes {:.2g} N m of joint '{}', whose motor gives "
      "{:.3g} N m, so the robot sinks; it needs a stronger motor, shorter legs, less weight or a "
      "home pose that asks less of it",
      standing.load, standing.joint, standing.limit);
}

}  // namespace legwright
