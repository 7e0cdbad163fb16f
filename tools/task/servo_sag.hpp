// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// Sag above which servos are called soft, and that of those that are stiff enough [rad]: trots of
/// robots that bend by 0.02 to 0.3 rad were followed badly or only just, those of robots that bend
/// by up to 0.01 rad were, from half their gains on (tools/README.md).
inline constexpr double kSoftSag = 0.015, kFirmSag = 0.01;

/// Where standing still in the home pose asks most of a motor, as a share of what that can give.
struct StandingLoad {
  std::string joint;   // empty: no servo at a joint has a limit
  double load = 0.0;   // [N m]
  double limit = 0.0;  // [N m]
  bool holds() const { return joint.empty() || load <= limit; }
};

/// How far standing still in the home pose bends the servo at a joint that gives in most, without
/// feed-forward.
struct ServoSag {
  std::string joint;    // empty: the robot has no servo at a joint
  double angle = 0.0;   // [rad]
  double kp = 0.0;      // of this servo [N m/rad]
  double load = 0.0;    // that it bears [N m]
  double limit = 0.0;   // what it can bear [N m]
  double torque = 0.0;  // the largest of any servo at a joint that stands [N m]
  StandingLoad hardest = {};
  bool soft() const { return angle > kSoftSag; }
  /// Gain with which no servo sags by more than kFirmSag, two digits [N m/rad].
  double stiff_kp() const;
  /// Whether a servo of stiff_kp() would be any stiffer, as far as the torque limit bears it.
  bool can_be_stiffer() const;
};

/// A positive number rounded up to two digits, as task files have gains.
double two_digits_up(double least);

/// @param robot with servos and masses as they are played
ServoSag servo_sag(const RobotModel& robot);
/// The same of a robot as a task has it played: its payload, its motors and servos.
ServoSag servo_sag(const RobotModel& robot, const Task& task);

/// Motors that do not hold the robot, which no gain mends; empty where they do.
std::string weak_motors_text(const StandingLoad& standing);

}  // namespace legwright
