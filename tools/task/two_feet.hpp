// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// What keeps a robot on two feet upright while it plays a plan that nothing corrects: round soles
/// as large as the leg, on which it rights itself, or flat ones on ankles stiffer than gravity tips
/// it.
struct TwoFeet {
  enum class Kind { no, round, flat, neither };  // no: the robot has more feet, or one
  Kind kind = Kind::no;
  double height = 0.0;    // h, of the COM [m]
  double toppling = 0.0;  // M g h: torque with which gravity tips it over its ankles [N m/rad]
  std::string ankle;      // hinge of those next to a foot with the weakest motor
  double limit = 0.0;     // of that motor; infinite for servos without limits [N m]
  double kp = 0.0;        // least of the ankles' [N m/rad]
  double kd = 0.0;        // least of the ankles' [N m s/rad]

  /// Gain with which ankles hold the robot at half of it, too, and damping in which it does not
  /// rock from step to step: two digits [N m/rad, N m s/rad].
  double upright_kp() const;
  double upright_kd() const;
  bool soft() const;
  bool is_underdamped() const;
  /// Whether its motor bears a stiffness that would hold.
  bool can_be_stiffer() const;
  /// Why it will fall, whatever the plan; empty where it need not.
  std::string why_it_falls() const;
};

TwoFeet two_feet(const RobotModel& robot);
/// The same of a robot as a task has it played: its payload, its motors and servos.
TwoFeet two_feet(const RobotModel& robot, const Task& task);

}  // namespace legwright
