// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/metrics_json.hpp"

namespace legwright {
namespace {

Json foot_json(const FootMeasures& foot) {
  return {{"name", foot.name},
          {"stances", foot.stances},
          {"missed_stances", foot.missed},
          {"slip_mean_m", foot.slip_mean},
          {"slip_max_m", foot.slip_max},
          {"touchdown_error_mean_s", foot.touchdown_mean},
          {"touchdown_error_max_s", foot.touchdown_max},
          {"swings", foot.swings},
          {"clearance_mean_m", foot.clearance_mean},
          {"clearance_min_m", foot.clearance_min},
          {"planned_stances_s", foot.planned},
          {"contacts_s", foot.contacts}};
}

Json joint_json(const JointMeasures& joint) {
  return {{"name", joint.name},
          {"torque_rms_Nm", joint.torque_rms},
          {"torque_peak_Nm", joint.torque_peak},
          {"torque_limit_Nm", joint.torque_limit},
          {"saturated_share", joint.saturated_share},
          {"tracking_rms_rad", joint.tracking_rms}};
}

// One number for all feet: the worst, and the mean of the means.
Json feet_summary(const std::vector<FootMeasures>& feet) {
  double slip_sum = 0.0, slip_max = 0.0, touchdown_sum = 0.0, touchdown_max = 0.0;
  for (const auto& foot : feet) {
    slip_sum += foot.slip_mean;
    slip_max = std::max(slip_max, foot.slip_max);
    touchdown_sum += foot.touchdown_mean;
    touchdown_max = std::max(touchdown_max, foot.touchdown_max);
  }
  const double count = feet.empty() ? 1.0 : static_cast<double>(feet.size());
  return {{"slip_mean_m", slip_sum / count},
          {"slip_max_m", slip_max},
          {"touchdown_error_mean_s", touchdown_sum / count},
          {"touchdown_error_max_s", touchdown_max}};
}

}  // namespace

Json measurements_json(const Measurements& m) {
  Json out = {{"gain_scale", m.gain_scale}, {"seconds", m.seconds}, {"cycles", m.cycles}};
  out["fall"] = m.fall ? Json{{"time_s", m.fall->time}, {"cause", m.fall->cause}} : Json(nullptr);
  out["diverged"] = m.diverged;
  out["warnings"] = Json::array();
  for (const auto& warning : m.warnings) {
    out["warnings"].push_back(
        {{"time_s", warning.time}, {"text", warning.text}, {"count", warning.count}});
  }
  out["velocity_mps"] = m.velocity ? Json{m.velocity->x(), m.velocity->y()} : Json(nullptr);
  out["speed_ratio"] = or_null(m.speed_ratio);
  out["speed_ratio_min"] = or_null(m.speed_ratio_min);
  out["speed_ratio_max"] = or_null(m.speed_ratio_max);
  out["plan_speed_ratio"] = or_null(m.plan_speed_ratio);
  out["lateral_drift_mps"] = or_null(m.lateral_drift);
  out["turn_rate_radps"] = or_null(m.turn_rate);
  out["turn_ratio"] = or_null(m.turn_ratio);
  out["heading_at_start_rad"] = m.heading_at_start;
  out["heading_drift_rad"] = m.heading_drift;
  out["tilt_max_rad"] = m.tilt_max;
  out["torque_rms_Nm"] = m.torque_rms;
  out["saturated_share"] = m.saturated_share;
  out["tracking_rms_rad"] = m.tracking_rms;
  out["penetration_max_m"] = m.penetration_max;
  out["self_contact_share"] = m.self_contact.share;
  out["self_contact_count"] = m.self_contact.count;
  out["self_contact_force_max_N"] = m.self_contact.force_max;
  out["self_contact_force_max_time_s"] =
      m.self_contact.count > 0 ? Json(m.self_contact.force_time) : Json(nullptr);
  out["self_contact_bodies"] = Json::array();
  if (m.self_contact.force_max > 0.0)
    out["self_contact_bodies"] = {m.self_contact.first, m.self_contact.second};
  out["power_mean_W"] = or_null(m.power_mean);
  out["cost_of_transport"] = or_null(m.cost_of_transport);
  out["feet_summary"] = feet_summary(m.feet);
  out["feet"] = Json::array();
  for (const auto& foot : m.feet) out["feet"].push_back(foot_json(foot));
  out["joints"] = Json::array();
  for (const auto& joint : m.joints) out["joints"].push_back(joint_json(joint));
  return out;
}

Json gains_json(const SceneValidation& validation) {
  Json out = Json::object();
  for (const auto& run : validation.at_gains)
    out[gain_name(run.gain_scale)] = measurements_json(run);
  return out;
}

Json verdict_json(const Verdict& verdict) {
  Json out = {{"pass", verdict.pass}, {"line", verdict.line}, {"reasons", verdict.reasons}};
  out["limits"] = Json::array();
  for (const auto& row : verdict.limits) {
    out["limits"].push_back({{"name", row.name},
                             {"what", row.what},
                             {"unit", row.unit},
                             {"low", or_null(row.bounds.low)},
                             {"high", or_null(row.bounds.high)},
                             {"value", or_null(row.value)},
                             {"where", row.where},
                             {"pass", row.pass}});
    if (row.strict) out["limits"].back()["strict"] = true;  // high itself does not pass
  }
  return out;
}

Json limits_json(const Limits& limits) {
  Json out = Json::object();
  for (const auto& [name, bounds] : limits)
    out[name] = {{"low", or_null(bounds.low)}, {"high", or_null(bounds.high)}};
  return out;
}

}  // namespace legwright
