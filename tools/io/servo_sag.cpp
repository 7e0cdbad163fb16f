// SPDX-License-Identifier: Apache-2.0
#include "tools/io/servo_sag.hpp"

#include <algorithm>
#include <cmath>

#include "optimizer/motion/standing.hpp"

namespace legwright {

double ServoSag::stiff_kp() const {
  const double least = torque / kFirmSag;
  const double unit = std::pow(10.0, std::floor(std::log10(least)) - 1.0);
  return std::ceil(least / unit - 1e-9) * unit;
}

ServoSag servo_sag(const RobotModel& robot) {
  const Eigen::VectorXd torques = standing_torques(robot.morphology, robot.space.initial());
  ServoSag sag;
  for (std::size_t a = 0; a < robot.servos.size(); ++a) {
    const Servo& servo = robot.servos[a];
    if (!servo.tendon.empty()) continue;
    const double torque = std::abs(torques[static_cast<Eigen::Index>(a)]);
    sag.torque = std::max(sag.torque, torque);
    if (!sag.joint.empty() && torque / servo.kp <= sag.angle) continue;
    sag.joint = servo.joint;
    sag.angle = torque / servo.kp;
    sag.kp = servo.kp;
  }
  return sag;
}

}  // namespace legwright
