// SPDX-License-Identifier: Apache-2.0
#include "tools/run/metrics_record.hpp"

#include <algorithm>

#include "tools/files/json_file.hpp"

namespace legwright {

void fields(Fields& f, Fall& fall) {
  f("time_s", fall.time);
  f("cause", fall.cause);
}

void fields(Fields& f, HealthWarning& warning) {
  f("time_s", warning.time, "of the first");
  f("text", warning.text);
  f("count", warning.count);
}

void fields(Fields& f, FeetSummary& feet) {
  f("slip_mean_m", feet.slip_mean);
  f("slip_max_m", feet.slip_max);
  f("touchdown_error_mean_s", feet.touchdown_mean);
  f("touchdown_error_max_s", feet.touchdown_max);
}

void fields(Fields& f, FootMetrics& foot) {
  f("name", foot.name);
  f("stances", foot.stances, "complete ones after the first cycle");
  f("missed_stances", foot.missed, "planned ones in which the foot never touched the ground");
  f("slip_mean_m", foot.slip_mean, "path of the contact point on the ground, per stance");
  f("slip_max_m", foot.slip_max);
  f("touchdown_error_mean_s", foot.touchdown_mean, "actual minus planned time: positive is late");
  f("touchdown_error_max_s", foot.touchdown_max, "largest magnitude");
  f("swings", foot.swings);
  f("clearance_mean_m", foot.clearance_mean, "how high a bar across each step may be");
  f("clearance_min_m", foot.clearance_min);
  f("planned_stances_s", foot.planned, "of the first cycle");
  f("contacts_s", foot.contacts, "measured, of the first seconds");
}

void fields(Fields& f, JointMetrics& joint) {
  f("name", joint.name);
  f("torque_rms_Nm", joint.torque_rms);
  f("torque_peak_Nm", joint.torque_peak);
  f("torque_limit_Nm", joint.torque_limit, "null without a limit");
  f("saturated_share", joint.saturated_share, "of the time");
  f("tracking_rms_rad", joint.tracking_rms, "target minus angle");
  f("saturated_time_s", joint.saturated_time, "when it was at its limit first");
}

namespace {

/// The touches stand in the file beside what else was measured.
void self_contact_fields(Fields& f, SelfContact& touch) {
  f("self_contact_share", touch.share, "of the time in which two bodies of the robot touch");
  f("self_contact_count", touch.count);
  std::optional<double> depth = touch.depth_max;
  f("self_contact_depth_max_m", depth, "to which two of its bodies went into each other");
  f("self_contact_force_max_N", touch.force_max);
  std::optional<double> time;
  if (touch.count > 0) time = touch.force_time;
  f.nullable("self_contact_force_max_time_s", time);
  std::vector<std::string> bodies;
  if (touch.force_max > 0.0) bodies = {touch.first, touch.second};
  f("self_contact_bodies", bodies, "between which that force was; empty without");
  if (f.reads()) {
    touch.depth_max = depth.value_or(0.0);
    touch.force_time = time.value_or(0.0);
    bodies.resize(2);
    touch.first = bodies[0];
    touch.second = bodies[1];
  }
}

}  // namespace

void fields(Fields& f, GainMetrics& m) {
  f("gain_scale", m.gain_scale, "times the servos' own gains");
  f("seconds", m.seconds, "simulated");
  f("cycles", m.cycles, "complete ones");
  f.nullable("fall", m.fall);
  f("diverged", m.diverged);
  f("warnings", m.warnings, "of MuJoCo");
  f.nullable("velocity_mps", m.velocity, "forward, left");
  f.nullable("speed_ratio", m.speed_ratio, "over the planned speed");
  f.nullable("speed_ratio_min", m.speed_ratio_min, "of single cycles");
  f.nullable("speed_ratio_max", m.speed_ratio_max);
  f.nullable("plan_speed_ratio", m.plan_speed_ratio, "over what the plan reached");
  f.nullable("lateral_drift_mps", m.lateral_drift, "across the wanted direction, to its left");
  f("path_deviation", m.path_deviation,
    "greatest distance from the wanted straight or arc over the length of the way");
  f.nullable("turn_rate_radps", m.turn_rate);
  f.nullable("turn_ratio", m.turn_ratio);
  f("heading_at_start_rad", m.heading_at_start);
  f("heading_drift_rad", m.heading_drift);
  f("tilt_max_rad", m.tilt_max);
  f("torque_rms_Nm", m.torque_rms, "over all servos");
  f("saturated_share", m.saturated_share, "of the time with any servo at its limit");
  f("tracking_rms_rad", m.tracking_rms, "over all joints");
  f("penetration_max_m", m.penetration_max, "of contacts with the ground");
  self_contact_fields(f, m.self_contact);
  f.nullable("power_mean_W", m.power_mean, "positive mechanical power of the servos");
  f.nullable("cost_of_transport", m.cost_of_transport, "that over weight times speed");
  f("floquet_multiplier", m.floquet_multiplier,
    "largest of the cycle: what a cycle multiplies a small disturbance by; below 1 it dies out");
  f("feet_summary", m.feet_summary);
  f("feet", m.feet);
  f("joints", m.joints);
}

void fields(Fields& f, LimitRange& range) {
  f.nullable("low", range.low);
  f.nullable("high", range.high);
}

template <class T>
void fields(Fields& f, BeforeAfter<T>& of) {
  f("initial", of.initial);
  f("result", of.result);
}

void fields(Fields& f, MetricsRecord& metrics) {
  f("task", metrics.task);
  f("wanted_velocity_mps", metrics.wanted_velocity, "forward, left");
  f("wanted_turn_rate_radps", metrics.wanted_turn_rate);
  f("plan_velocity_mps", metrics.plan_velocity, "that the plan itself reaches");
  f("cycles", metrics.cycles, "of each roll-out");
  f("timestep_s", metrics.timestep);
  f("robot_mass_kg", metrics.robot_mass);
  f("limits", metrics.limits, "that the verdict was judged by");
  f("versions", metrics.versions);
  f("initial", metrics.initial, "by servo gains");
  f("result", metrics.result);
  of_field(f, metrics.of);
}

std::optional<MetricsRecord> read_metrics(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Json json = load_json(file, kind_of<MetricsRecord>());
  if (is_kind(json, {"legwright/iteration", 1})) return std::nullopt;
  return record_of<MetricsRecord>(json, file.string());
}

FeetSummary summary_of(const std::vector<FootMetrics>& feet) {
  FeetSummary out;
  for (const FootMetrics& foot : feet) {
    out.slip_mean += foot.slip_mean;
    out.slip_max = std::max(out.slip_max, foot.slip_max);
    out.touchdown_mean += foot.touchdown_mean;
    out.touchdown_max = std::max(out.touchdown_max, foot.touchdown_max);
  }
  const double count = feet.empty() ? 1.0 : static_cast<double>(feet.size());
  out.slip_mean /= count;
  out.touchdown_mean /= count;
  return out;
}

}  // namespace legwright
