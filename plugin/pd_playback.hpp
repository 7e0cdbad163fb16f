// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <vector>

#include "plugin/clock.hpp"
#include "plugin/robot_names.hpp"
#include "plugin/servo.hpp"
#include "plugin/spline.hpp"
#include "plugin/trajectory.hpp"

namespace legwright {

/// One instance of the plugin `legwright.gait`: which joint each of its actuators plays, and the
/// servo law
///   τ = kp·(q* + ctrl − q) + kd·(v* − v) + ff·w·τ_ff
/// with the gait's Q, Q̇ and τ_ff taken at plan time s = t0 + speed·time, and from rest
///   q* = q_rest + w·(Q(s) − q_rest),   v* = w·speed·Q̇(s) + ẇ·(Q(s) − q_rest) = dq*/dt.
/// A linear actuator, on a tendon over one hinge, does the same along its length:
///   F = kp·(L(q*) + ctrl − L) + kd·(L′(q*) v* − L̇) + ff·w·τ_ff/L′(q*).
/// Where the motor is known, no more than it has left at its speed (Servo::most).
/// Immutable once made: what it does depends on the model, `d->time`, `d->ctrl` and the joints
/// only, so resets, copies, jumps of time and threads with their own mjData need no further care.
class PdPlayback {
 public:
  /// What a joint is asked to do.
  struct Target {
    double position = 0.0, velocity = 0.0;  // q*, v*
  };

  /// Reads the configuration of `instance`. Throws std::runtime_error with a reason for the user's
  /// eyes if the configuration, the trajectory and the model do not fit together.
  PdPlayback(const mjModel* m, int instance);

  /// Writes d->actuator_force of the instance's actuators [N·m, on tendons and slides N]; 0 for
  /// those of a disabled group.
  void apply_torque(const mjModel* m, mjData* d) const noexcept;

  const Trajectory& trajectory() const noexcept { return *trajectory_; }
  const RobotNames& names() const noexcept { return names_; }
  const Clock& clock() const noexcept { return clock_; }
  const std::vector<Servo>& servos() const noexcept { return servos_; }
  int ghost_group() const noexcept { return ghost_group_; }
  /// The moment of the gait at `time` [s] of the simulation.
  SplinePhase phase(double time) const noexcept {
    return phase_at(*trajectory_, clock_.plan_time(time));
  }
  Target target(const Servo& servo, const SplinePhase& phase, const Blend& blend) const noexcept;

 private:
  std::shared_ptr<const Trajectory> trajectory_;
  RobotNames names_;
  std::vector<Servo> servos_;
  Clock clock_;
  double ff_ = 1.0;
  int ghost_group_ = 0;
};

}  // namespace legwright
