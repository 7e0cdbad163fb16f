// SPDX-License-Identifier: Apache-2.0
#include "tools/run/comparison_record.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tools/files/io_error.hpp"

namespace legwright {

void fields(Fields& f, Curve& curve) {
  f.nullable("planned", curve.planned);
  f("mean", curve.mean, "of the played cycles");
  f("low", curve.low, "least of their means within a bin");
  f("high", curve.high);
}

void fields(Fields& f, NamedCurve& named) {
  f("name", named.name);
  f("label", named.label);
  f("unit", named.unit);
  fields(f, named.curve);
}

void fields(Fields& f, MeanAndWorst& value) {
  f("mean", value.mean, "over the stances");
  f("worst", value.worst, "largest magnitude");
  f("planned", value.planned);
}

void fields(Fields& f, FootComparison& foot) {
  f("name", foot.name);
  f("force_normal_N", foot.normal);
  f("force_tangential_N", foot.tangential);
  f("height_m", foot.height, "of its lowest point above the ground");
  f("slip_speed_mps", foot.slip_speed, "0 in the air");
  f("friction_used", foot.friction, "tangential over normal force, 0 in the air");
  f("contact", foot.contact, "share of the time");
  f("touchdown_error_s", foot.touchdown, "actual minus planned time: positive is late");
  f("liftoff_error_s", foot.liftoff);
  f("landing_speed_mps", foot.landing_speed);
  f("slip_m", foot.slip);
  f("roll_rad", foot.roll, "angle by which the foot rolled in a stance");
}

void fields(Fields& f, JointComparison& joint) {
  f("name", joint.name);
  f("angle_rad", joint.angle);
  f("torque_Nm", joint.torque, "planned: feed-forward");
  f("limit_Nm", joint.torque_limit, "null without a limit");
  f("power_W", joint.power);
}

void fields(Fields& f, CycleComparison& cycle) {
  f("cycle", cycle.cycle);
  f.nullable("speed_ratio", cycle.speed_ratio);
  f.nullable("turn_ratio", cycle.turn_ratio);
  f("heading_rad", cycle.heading, "at its end, less what the plan has there");
  f("tilt_max_rad", cycle.tilt_max);
  f("power_W", cycle.power, "positive, of all joints, mean");
  f.nullable("cost_of_transport", cycle.cost_of_transport);
  f("saturated_share", cycle.saturated_share, "of the time with any servo at its limit");
}

void fields(Fields& f, ComparedPaths& paths) {
  f("planned", paths.planned);
  f("measured", paths.measured);
}

void fields(Fields& f, InverseDynamics& d) {
  f("residual_force_share_max", d.force_max, "of the weight");
  f("residual_force_share_rms", d.force_rms);
  f("residual_torque_share_max", d.torque_max, "of weight times trunk height");
  f("residual_torque_share_rms", d.torque_rms);
  f("worst_phase", d.worst_phase);
  f("residual_force_share", d.force, "by phase");
  f("friction_used_max", d.friction_max);
  f("friction_coefficient", d.friction_coefficient, "of the floor");
  f("friction_worst_foot", d.friction_foot);
  f("friction_worst_phase", d.friction_phase);
  f("normal_force_min_N", d.normal_min, "of feet that the plan has on the ground");
  f("normal_force_min_share", d.normal_min_share, "of the weight");
  f("normal_force_min_foot", d.normal_foot);
  f("normal_force_min_phase", d.normal_phase);
}

void fields(Fields& f, Comparison& c) {
  f("gain_scale", c.gain_scale);
  f("cycles", c.cycles, "first and last of the curves");
  f("period_s", c.period);
  f("phases", c.phases, "centres of the bins, share of the period");
  f("curves", c.curves, "of the whole robot");
  f("feet", c.feet);
  f("joints", c.joints);
  f("cycle_table", c.cycle_table, "all complete cycles");
  f("path_xy", c.paths, "of the centre of mass, world, in metres");
  f("warnings", c.warnings, "of MuJoCo");
  f("inverse_dynamics", c.inverse_dynamics, "what the plan needs beyond its own forces");
}

void fields(Fields& f, ComparisonRecord& comparison) {
  f.nullable("initial", comparison.initial, "null where it fell before two cycles");
  f.nullable("result", comparison.result);
  of_field(f, comparison.of);
}

namespace {

double rounded(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double digits = 5 - std::floor(std::log10(std::abs(value)));
  // A power of ten that is whole divides or multiplies without an error of its own.
  const double power = std::pow(10.0, std::min(300.0, std::abs(digits)));
  return digits >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

/// Calls `see` with each list of a number for each phase, and where it stands.
template <class See>
void each_list(Comparison& c, const See& see) {
  const auto curve = [&](Curve& one, const std::string& where) {
    if (one.planned) see(*one.planned, where + ".planned");
    see(one.mean, where + ".mean");
    see(one.low, where + ".low");
    see(one.high, where + ".high");
  };
  see(c.phases, "phases");
  see(c.inverse_dynamics.force, "inverse_dynamics.residual_force_share");
  for (NamedCurve& named : c.curves) curve(named.curve, "curves: " + named.name);
  for (FootComparison& foot : c.feet)
    for (Curve* one : {&foot.normal, &foot.tangential, &foot.height, &foot.slip_speed,
                       &foot.friction, &foot.contact})
      curve(*one, "feet: " + foot.name);
  for (JointComparison& joint : c.joints)
    for (Curve* one : {&joint.angle, &joint.torque, &joint.power})
      curve(*one, "joints: " + joint.name);
}

}  // namespace

ComparisonRecord read_comparison(const std::filesystem::path& file) {
  ComparisonRecord record = read_record_file<ComparisonRecord>(file);
  for (auto* design : {&record.initial, &record.result}) {
    if (!*design) continue;
    each_list(**design, [&](const Eigen::VectorXd& list, const std::string& where) {
      if (list.size() != (*design)->phases.size())
        throw IoError(fmt::format("{}: {}: expected {} numbers as in phases, found {}",
                                  file.string(), where, (*design)->phases.size(), list.size()));
    });
  }
  return record;
}

Comparison rounded_curves(Comparison comparison) {
  each_list(comparison, [](Eigen::VectorXd& list, const std::string&) {
    for (double& value : list) value = rounded(value);
  });
  for (auto* path : {&comparison.paths.planned, &comparison.paths.measured})
    for (Eigen::Vector2d& point : *path) point = {rounded(point.x()), rounded(point.y())};
  return comparison;
}

}  // namespace legwright
