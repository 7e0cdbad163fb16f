// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plugin/hinge_length.hpp"
#include "plugin/trajectory.hpp"

namespace legwright {

/// One instance of the plugin `legwright.gait`: which joint each of its actuators plays, and the
/// servo law
///   τ = kp·(q* + ctrl − q) + kd·(v* − v) + τ_ff    at time d->time + t0.
/// A linear actuator, on a tendon over one hinge, does the same along its length:
///   F = kp·(L(q*) + ctrl − L) + kd·(L′(q*) v* − L̇) + τ_ff/L′(q*).
/// Immutable once made: what it does depends on the model, `d->time`, `d->ctrl` and the joints
/// only, so resets, copies, jumps of time and threads with their own mjData need no further care.
class PdPlayback {
 public:
  /// Reads the configuration of `instance`. Throws std::runtime_error with a reason for the user's
  /// eyes if the configuration, the trajectory and the model do not fit together.
  PdPlayback(const mjModel* m, int instance);

  /// Writes d->actuator_force of the instance's actuators [N·m, on tendons N]; 0 for those of a
  /// disabled group.
  void apply_torque(const mjModel* m, mjData* d) const noexcept;

  /// Writes q* − q [rad] of each actuator's joint into the sensors of the instance.
  void measure_tracking_error(const mjModel* m, mjData* d, int instance) const noexcept;

 private:
  struct Servo {
    int actuator = 0, joint = 0;        // MuJoCo's
    int column = 0, torque_column = 0;  // of the trajectory
    double kp = 0.0, kd = 0.0;
    std::optional<HingeLength> length;  // of a linear actuator
  };

  std::shared_ptr<const Trajectory> trajectory_;
  std::vector<Servo> servos_;
  double start_time_ = 0.0;  // t0, s
};

/// Number of actuators of an instance: the dimension of its sensors.
int servo_count(const mjModel* m, int instance) noexcept;

}  // namespace legwright
