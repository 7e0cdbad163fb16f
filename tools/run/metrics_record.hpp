// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/run/judged_sums.hpp"
#include "tools/run/record.hpp"
#include "tools/simulate/incidents.hpp"

namespace legwright {

/// How a foot kept to the plan. Strides of the first cycle do not count.
struct FootMetrics {
  std::string name;
  int stances = 0;         // complete ones that were looked at
  int missed = 0;          // planned stances in which the foot never touched the ground
  double slip_mean = 0.0;  // path of the contact point on the ground during one stance [m]
  double slip_max = 0.0;
  double touchdown_mean = 0.0;  // actual minus planned time of touchdown [s]: positive is late
  double touchdown_max = 0.0;   // largest magnitude of that [s]
  int swings = 0;               // planned ones that were looked at; then how high a bar across each
                                // step may be, 0 where the foot never left the ground [m]
  double clearance_mean = 0.0, clearance_min = 0.0;
  /// Stances of the plan in the first cycle, [touchdown, last knot with force] [s]; the second may
  /// exceed the period.
  std::vector<std::pair<double, double>> planned;
  std::vector<std::pair<double, double>> contacts;  // measured, up to a limit [s]
};

/// Of one servo, after the first cycle.
struct JointMetrics {
  std::string name;
  double torque_rms = 0.0, torque_peak = 0.0;  // of qfrc_actuator [N m]
  double torque_limit = 0.0;                   // [N m], not finite if there is none
  double saturated_share = 0.0;                // of the time
  double tracking_rms = 0.0;                   // target − angle [rad]
  std::optional<double> saturated_time = {};   // when it was at its limit first [s]
};

/// How a robot touched itself during a roll-out, legs against legs for instance.
struct SelfContact {
  double share = 0.0;         // of the time in which any two of its bodies touch
  int count = 0;              // touches: of any two bodies, from their meeting to their parting
  double force_max = 0.0;     // largest normal force between two bodies [N]
  double force_time = 0.0;    // when that was [s], since the start
  std::string first, second;  // between which bodies; empty if there was none
  double depth_max = 0.0;     // to which two of its bodies went into each other [m]
};

/// What happened in one roll-out. Absent numbers could not be measured: the robot fell too early,
/// or they mean nothing for this task. Speeds are those of the COM, means over the cycles after the
/// first two, each along the arc on which the robot went while it turned, in its own heading:
/// forward is where the trunk's x axis points on the ground.
struct RolloutMetrics {
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
  /// Greatest distance from the straight or the arc on which it should go, of its COM at the ends
  /// of the cycles, over the length of that way.
  std::optional<double> path_deviation;
  std::optional<double> turn_rate;   // [rad/s]
  std::optional<double> turn_ratio;  // over the task's turn rate
  double heading_at_start = 0.0;     // of the trunk in the plan at phase 0; 0 is wanted [rad]
  double heading_drift = 0.0;        // turned by at the end, less what the task wants [rad]
  double tilt_max = 0.0;             // [rad]

  std::vector<JointMetrics> joints;
  double saturated_share = 0.0;  // of the time after the first cycle with any servo at its limit
  double torque_rms = 0.0;       // over all servos [N m]
  double tracking_rms = 0.0;     // over all joints [rad]
  double penetration_max = 0.0;  // of contacts with the ground [m]
  SelfContact self_contact;      // of the robot with itself
  std::optional<double> power_mean;         // positive mechanical power of the servos [W]
  std::optional<double> cost_of_transport;  // that over weight × speed
  /// Largest Floquet multiplier of the cycle: below 1 small disturbances die out.
  std::optional<double> floquet_multiplier;
};

/// One number for all feet: the mean of the means, and the worst.
struct FeetSummary {
  double slip_mean = 0.0, slip_max = 0.0;            // [m]
  double touchdown_mean = 0.0, touchdown_max = 0.0;  // [s]
};

/// A roll-out as metrics.json tells it.
struct GainMetrics : RolloutMetrics {
  FeetSummary feet_summary;
  std::vector<FootMetrics> feet;
};

/// What passes, both ends included.
struct LimitRange {
  std::optional<double> low, high;
};

/// The same of the initial design and of the result.
template <class T>
struct BeforeAfter {
  T initial{}, result{};
};

/// The gains of a validation, in the order in which they are told.
inline constexpr std::array<const char*, 3> kGains{"half", "default", "double"};

/// result/metrics.json once a run is validated: what was measured of the initial design and of the
/// result, by the servo gains ("half", "default", "double"). Until then the file is that of the
/// last iteration.
struct MetricsRecord {
  static constexpr RecordKind kKind{"legwright/validation", 1, "validate"};
  std::string task;                                  // "trot forward at 0.100 m/s"
  Eigen::Vector2d wanted_velocity{0.0, 0.0};         // [m/s]
  double wanted_turn_rate = 0.0;                     // [rad/s]
  BeforeAfter<std::array<double, 2>> plan_velocity;  // [m/s]
  int cycles = 0;                                    // of each roll-out
  double timestep = 0.0;                             // [s]
  BeforeAfter<double> robot_mass;                    // [kg]
  std::map<std::string, LimitRange> limits;
  ByName<std::string> versions;
  ByName<GainMetrics> initial, result;
  std::optional<JudgedSums> of = {};
};

void fields(Fields& f, Fall& fall);
void fields(Fields& f, HealthWarning& warning);
void fields(Fields& f, GainMetrics& metrics);
void fields(Fields& f, LimitRange& range);
void fields(Fields& f, MetricsRecord& metrics);

/// The metrics.json of a validated run; nothing where the file is not there or still that of the
/// last iteration. Throws as read_record_file.
std::optional<MetricsRecord> read_metrics(const std::filesystem::path& file);

/// The worst of all feet.
FeetSummary summary_of(const std::vector<FootMetrics>& feet);

}  // namespace legwright
