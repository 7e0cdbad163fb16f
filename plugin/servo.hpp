// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

#include "plugin/hinge_length.hpp"
#include "plugin/playback_config.hpp"

namespace legwright {

/// One actuator of an instance, and what it plays.
struct Servo {
  int actuator = 0, joint = 0;        // MuJoCo's
  int column = 0, torque_column = 0;  // of the trajectory
  double kp = 0.0, kd = 0.0;
  double rest = 0.0;                  // position of the joint at rest [rad or m]
  std::optional<HingeLength> length;  // of a linear actuator
  // Torque at rest [N·m] and speed without load [rad/s]; on tendons and slides N, m/s. Zeros: its
  // torque does not fall with speed.
  double stall_torque = 0.0, no_load_speed = 0.0;

  /// The most and the least force that the motor has left at a velocity of its joint or tendon:
  /// ± stall_torque, less what its speed takes. What turns it faster than it runs by itself is
  /// braked.
  double most(double velocity) const noexcept;
  double least(double velocity) const noexcept { return -most(-velocity); }
};

/// Number of actuators of an instance.
int servo_count(const mjModel* m, int instance) noexcept;

/// The actuators of an instance, in their order in the model, each with its columns and gains.
/// Throws ConfigError, naming the actuator, where one cannot be played as the trajectory, the gains
/// and the law of the servo say, or where the trajectory has a joint that none drives.
std::vector<Servo> bind_servos(const mjModel* m, int instance, const PlaybackConfig& config);

/// Name of an object in quotes, or its number, for messages.
std::string name_of(const mjModel* m, mjtObj type, int id);

}  // namespace legwright
