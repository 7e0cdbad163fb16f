// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/comparison_json.hpp"

#include <cmath>

namespace legwright {
namespace {

double rounded(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double digits = 5 - std::floor(std::log10(std::abs(value)));
  // A power of ten that is whole divides or multiplies without an error of its own.
  const double power = std::pow(10.0, std::min(300.0, std::abs(digits)));
  return digits >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

Json numbers(const Eigen::VectorXd& values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(rounded(value));
  return out;
}

Json curve_json(const Curve& curve) {
  return {{"planned", curve.planned ? numbers(*curve.planned) : Json(nullptr)},
          {"mean", numbers(curve.mean)},
          {"low", numbers(curve.low)},
          {"high", numbers(curve.high)}};
}

Json stances_json(const MeanAndWorst& value) {
  return {{"mean", value.mean}, {"worst", value.worst}};
}

Json foot_json(const FootComparison& foot) {
  Json slip = stances_json(foot.slip), roll = stances_json(foot.roll);
  slip["planned"] = foot.slip_planned;
  roll["planned"] = foot.roll_planned;
  return {{"name", foot.name},
          {"force_normal_N", curve_json(foot.normal)},
          {"force_tangential_N", curve_json(foot.tangential)},
          {"height_m", curve_json(foot.height)},
          {"slip_speed_mps", curve_json(foot.slip_speed)},
          {"friction_used", curve_json(foot.friction)},
          {"contact", curve_json(foot.contact)},
          {"touchdown_error_s", stances_json(foot.touchdown)},
          {"liftoff_error_s", stances_json(foot.liftoff)},
          {"landing_speed_mps", stances_json(foot.landing_speed)},
          {"slip_m", slip},
          {"roll_rad", roll}};
}

Json cycle_json(const CycleComparison& cycle) {
  return {{"cycle", cycle.cycle},
          {"speed_ratio", or_null(cycle.speed_ratio)},
          {"turn_ratio", or_null(cycle.turn_ratio)},
          {"heading_rad", cycle.heading},
          {"tilt_max_rad", cycle.tilt_max},
          {"power_W", cycle.power},
          {"cost_of_transport", or_null(cycle.cost_of_transport)},
          {"saturated_share", cycle.saturated_share}};
}

Json path_json(const std::vector<Eigen::Vector2d>& path) {
  Json out = Json::array();
  for (const auto& point : path) out.push_back({rounded(point.x()), rounded(point.y())});
  return out;
}

Json dynamics_json(const InverseDynamics& d) {
  return {{"residual_force_share_max", d.force_max},
          {"residual_force_share_rms", d.force_rms},
          {"residual_torque_share_max", d.torque_max},
          {"residual_torque_share_rms", d.torque_rms},
          {"worst_phase", d.worst_phase},
          {"residual_force_share", numbers(d.force)},
          {"friction_used_max", d.friction_max},
          {"friction_coefficient", d.friction_coefficient},
          {"friction_worst_foot", d.friction_foot},
          {"friction_worst_phase", d.friction_phase},
          {"normal_force_min_N", d.normal_min},
          {"normal_force_min_share", d.normal_min_share},
          {"normal_force_min_foot", d.normal_foot},
          {"normal_force_min_phase", d.normal_phase}};
}

Json design_json(const Comparison& c) {
  Json curves = Json::array(), feet = Json::array(), joints = Json::array(), cycles = Json::array(),
       warnings = Json::array();
  for (const auto& named : c.curves) {
    Json curve{{"name", named.name}, {"label", named.label}, {"unit", named.unit}};
    curve.update(curve_json(named.curve));
    curves.push_back(curve);
  }
  for (const auto& foot : c.feet) feet.push_back(foot_json(foot));
  for (const auto& joint : c.joints) {
    joints.push_back(
        {{"name", joint.name},
         {"angle_rad", curve_json(joint.angle)},
         {"torque_Nm", curve_json(joint.torque)},
         {"limit_Nm", std::isfinite(joint.torque_limit) ? Json(joint.torque_limit) : Json(nullptr)},
         {"power_W", curve_json(joint.power)}});
  }
  for (const auto& cycle : c.cycles) cycles.push_back(cycle_json(cycle));
  for (const auto& warning : c.warnings) {
    warnings.push_back(
        {{"time_s", warning.time}, {"text", warning.text}, {"count", warning.count}});
  }
  return {{"gain_scale", c.gain_scale},
          {"cycles", {c.first_cycle, c.last_cycle}},
          {"period_s", c.period},
          {"phases", numbers(c.phases)},
          {"curves", curves},
          {"feet", feet},
          {"joints", joints},
          {"cycle_table", cycles},
          {"path_xy",
           {{"planned", path_json(c.planned_path)}, {"measured", path_json(c.measured_path)}}},
          {"warnings", warnings},
          {"inverse_dynamics", dynamics_json(c.inverse_dynamics)}};
}

}  // namespace

Json comparison_json(const std::optional<Comparison>& initial,
                     const std::optional<Comparison>& result) {
  return {{"schema", "legwright/comparison"},
          {"version", 1},
          {"initial", initial ? design_json(*initial) : Json(nullptr)},
          {"result", result ? design_json(*result) : Json(nullptr)}};
}

}  // namespace legwright
