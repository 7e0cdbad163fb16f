// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulate/rollout.hpp"
#include "tools/validate/foot_watch.hpp"
#include "tools/validate/self_contact.hpp"

namespace legwright {

/// What the task wants of the trunk.
struct WantedMotion {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // forward, left in the heading frame [m/s]
  double turn_rate = 0.0;                              // [rad/s]

  bool travels() const { return velocity.norm() > 1e-6; }
  bool turns() const { return std::abs(turn_rate) > 1e-6; }
};

/// Of one servo, after the first cycle.
struct JointMeasures {
  std::string name;
  double torque_rms = 0.0, torque_peak = 0.0;  // of qfrc_actuator [N m]
  double torque_limit = 0.0;                   // [N m], infinite if there is none
  double saturated_share = 0.0;                // of the time
  double tracking_rms = 0.0;                   // target − angle [rad]
};

/// What happened in one roll-out. Absent numbers could not be measured: the robot fell too early,
/// or they mean nothing for this task. Speeds are those of the COM, means over the cycles after the
/// first two, each along the arc on which the robot went while it turned, in its own heading: forward
/// is where the trunk's x axis points on the ground.
struct Measurements {
  double gain_scale = 1.0;
  double seconds = 0.0;  // simulated
  int cycles = 0;        // complete ones
  std::optional<Fall> fall;
  std::vector<HealthWarning> warnings;
  bool diverged = false;

  std::optional<Eigen::Vector2d> velocity;  // forward, left [m/s]
  std::optional<double> speed_ratio;        // over the planned speed, which is the task's
  std::optional<double> speed_ratio_min, speed_ratio_max;  // of single cycles
  std::optional<double> plan_speed_ratio;                  // over what the plan reached
  std::optional<double> lateral_drift;  // across the wanted direction [m/s], positive to its left
  std::optional<double> turn_rate;      // [rad/s]
  std::optional<double> turn_ratio;     // over the task's turn rate
  double heading_at_start = 0.0;        // of the trunk in the plan at phase 0; 0 is wanted [rad]
  double heading_drift = 0.0;           // turned by at the end, less what the task wants [rad]
  double tilt_max = 0.0;                // [rad]

  std::vector<FootMeasures> feet;
  std::vector<JointMeasures> joints;
  double saturated_share = 0.0;  // of the time after the first cycle with any servo at its limit
  double torque_rms = 0.0;       // over all servos [N m]
  double tracking_rms = 0.0;     // over all joints [rad]
  double penetration_max = 0.0;  // of contacts with the ground [m]
  SelfContact self_contact;      // of the robot with itself
  std::optional<double> power_mean;         // positive mechanical power of the servos [W]
  std::optional<double> cost_of_transport;  // that over weight × speed
};

struct MeasureOptions {
  int settle_cycles = 2;        // left out of the speeds
  double contacts_until = 4.0;  // record contacts of the feet up to here [s]
};

/// Plays the scene and measures. @param plan_velocity that the plan reached along its arc [m/s], heading frame;
/// zero if unknown.
/// @param played if given, receives the roll-out itself (frames).
/// @param also sees each moment of the same roll-out
Measurements measure(const Scene& scene, const WantedMotion& wanted,
                     const Eigen::Vector2d& plan_velocity, const RolloutOptions& rollout_options,
                     const MeasureOptions& options = {}, Rollout* played = nullptr,
                     const std::function<void(const RolloutSample&)>& also = {});

}  // namespace legwright
