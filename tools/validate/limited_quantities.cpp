// SPDX-License-Identifier: Apache-2.0
// What limits may be set on. The order is that of the verdict: causes before consequences.
#include <algorithm>
#include <cmath>

#include "tools/validate/limits.hpp"
#include "tools/validate/worst_parts.hpp"

namespace legwright {
namespace {

constexpr double kBackwards = -1e9;  // the least of what may go the other way than planned

bool travels(const WantedMotion& wanted) { return wanted.travels(); }
bool turns(const WantedMotion& wanted) { return wanted.turns(); }
bool circles(const WantedMotion& wanted) { return wanted.travels() && wanted.turns(); }
bool stays(const WantedMotion& wanted) { return !wanted.travels(); }

template <typename Value>
double greatest(const std::vector<FootMeasures>& feet, const Value& value) {
  double out = 0.0;
  for (const auto& foot : feet) out = std::max<double>(out, value(foot));
  return out;
}

double peak_torque_share(const Measurements& run) {
  double out = 0.0;
  for (const auto& joint : run.joints) out = std::max(out, torque_share(joint));
  return out;
}

// Feet that are never planned to lift do not step.
std::optional<double> least_clearance(const Measurements& run) {
  std::optional<double> least;
  for (const auto& foot : run.feet)
    if (foot.swings > 0) least = std::min(least.value_or(foot.clearance_min), foot.clearance_min);
  return least;
}

// The radius of the way over that of the plan; both are speed over turn rate.
std::optional<double> radius_ratio(const Measurements& run) {
  if (!run.speed_ratio || !run.turn_ratio || *run.turn_ratio == 0.0) return std::nullopt;
  return *run.speed_ratio / *run.turn_ratio;
}

// Per cycle, so that a limit means the same for however many are played.
std::optional<double> heading_drift_per_cycle(const Measurements& run) {
  if (run.cycles < 1) return std::nullopt;
  return std::abs(run.heading_drift) / run.cycles;
}

/// What nobody has to ask for. README.md beside this file says why the bounds are what they are.
std::vector<LimitedQuantity> judged_by_default() {
  return {
      {.name = "saturated_share",
       .what = "share of the time with any servo at its limit",
       .unit = "1",
       .verb = "saturates servos",
       .note = "of the time",
       .told = Told::percent,
       .below = true,
       .most = 1.0,
       .by_default = {{}, 1e-3},
       .value = [](const Measurements& run) { return run.saturated_share; },
       .worst = saturated_joints},
      {.name = "self_contact",
       .what = "share of the time in which the robot touches itself",
       .unit = "1",
       .verb = "touches itself",
       .note = "of the time",
       .told = Told::percent,
       .most = 1.0,
       .by_default = {{}, 0.01},
       .value = [](const Measurements& run) { return run.self_contact.share; },
       .worst = touching_bodies},
      {.name = "self_contact_depth",
       .what = "how deep two bodies of the robot go into each other",
       .unit = "m",
       .verb = "strikes itself, bodies going into each other by",
       .note = "",
       .by_default = {{}, 0.001},
       .value = [](const Measurements& run) { return run.self_contact.depth_max; },
       .worst = touching_bodies},
      {.name = "speed_ratio",
       .what = "measured over planned speed, along its heading",
       .unit = "1",
       .verb = "reaches",
       .note = "of the planned speed",
       .told = Told::percent,
       .least = kBackwards,
       .by_default = {0.95, 1.05},
       .asked = travels,
       .value = [](const Measurements& run) { return run.speed_ratio; }},
      {.name = "standing_speed",
       .what = "speed where none is wanted",
       .unit = "m/s",
       .verb = "moves at",
       .note = "it should stay",
       .told = Told::thousandths,
       .by_default = {{}, 0.01},
       .asked = stays,
       .value = [](const Measurements& run) -> std::optional<double> {
         return run.velocity ? std::optional(run.velocity->norm()) : std::nullopt;
       }},
      {.name = "turn_ratio",
       .what = "measured over planned turn rate",
       .unit = "1",
       .verb = "turns at",
       .note = "of the planned turn rate",
       .told = Told::percent,
       .least = kBackwards,
       .by_default = {0.95, 1.05},
       .asked = turns,
       .value = [](const Measurements& run) { return run.turn_ratio; }},
      {.name = "radius_ratio",
       .what = "measured over planned radius of its circle",
       .unit = "1",
       .verb = "circles at",
       .note = "of the planned radius",
       .told = Told::percent,
       .least = kBackwards,
       .by_default = {0.95, 1.05},
       .asked = circles,
       .value = radius_ratio},
      {.name = "tilt",
       .what = "largest tilt of the trunk",
       .unit = "rad",
       .verb = "tilts by",
       .note = "",
       .told = Told::thousandths,
       .below = true,
       .by_default = {{}, 0.1},
       .value = [](const Measurements& run) { return run.tilt_max; }},
      {.name = "heading_drift_per_cycle",
       .what = "turned by at the end, less what is wanted, a cycle",
       .unit = "rad",
       .verb = "drifts in heading by",
       .note = "a cycle",
       .by_default = {{}, 0.01},
       .value = heading_drift_per_cycle},
      {.name = "path_deviation",
       .what = "greatest distance from the wanted straight or arc over the way",
       .unit = "1",
       .verb = "goes astray by",
       .note = "of the way",
       .told = Told::percent,
       .by_default = {{}, 0.1},
       .asked = travels,
       .value = [](const Measurements& run) { return run.path_deviation; }},
  };
}

std::vector<LimitedQuantity> judged_if_asked() {
  return {
      {.name = "slowest_cycle",
       .what = "speed of the slowest cycle over the planned",
       .unit = "1",
       .verb = "reaches in one cycle only",
       .note = "of the planned speed",
       .told = Told::percent,
       .least = kBackwards,
       .asked = travels,
       .value = [](const Measurements& run) { return run.speed_ratio_min; }},
      {.name = "heading_drift",
       .what = "turned by at the end, less what is wanted",
       .unit = "rad",
       .verb = "drifts in heading by",
       .note = "",
       .value = [](const Measurements& run) { return std::abs(run.heading_drift); }},
      {.name = "lateral_drift",
       .what = "speed across the wanted direction",
       .unit = "m/s",
       .verb = "drifts aside at",
       .note = "",
       .asked = travels,
       .value = [](const Measurements& run) -> std::optional<double> {
         return run.lateral_drift ? std::optional(std::abs(*run.lateral_drift)) : std::nullopt;
       }},
      {.name = "slip",
       .what = "longest way that a foot slips in one stance",
       .unit = "m",
       .verb = "slips by",
       .note = "",
       .value =
           [](const Measurements& run) {
             return greatest(run.feet, [](const auto& foot) { return foot.slip_max; });
           },
       .worst = worst_feet([](const FootMeasures& foot) { return foot.slip_max; })},
      {.name = "touchdown_error",
       .what = "largest error in time of a touchdown",
       .unit = "s",
       .verb = "sets its feet down off their time by",
       .note = "",
       .value =
           [](const Measurements& run) {
             return greatest(run.feet, [](const auto& foot) { return foot.touchdown_max; });
           },
       .worst = worst_feet([](const FootMeasures& foot) { return foot.touchdown_max; })},
      {.name = "liftoff_error",
       .what = "largest error in time of a lift-off",
       .unit = "s",
       .verb = "lifts its feet off their time by",
       .note = "",
       .value =
           [](const Measurements& run) {
             return greatest(run.feet, [](const auto& foot) { return foot.liftoff_max; });
           },
       .worst = worst_feet([](const FootMeasures& foot) { return foot.liftoff_max; })},
      {.name = "landing_speed",
       .what = "greatest speed at which a foot meets the ground",
       .unit = "m/s",
       .verb = "lands at",
       .note = "",
       .value =
           [](const Measurements& run) {
             return greatest(run.feet, [](const auto& foot) { return foot.landing_max; });
           },
       .worst = worst_feet([](const FootMeasures& foot) { return foot.landing_max; })},
      {.name = "foot_clearance",
       .what = "height of a bar across each step that every foot passes over",
       .unit = "m",
       .verb = "steps over no more than",
       .note = "",
       .least = kBackwards,
       .value = least_clearance,
       .worst = least_lifted_foot},
      {.name = "missed_stances",
       .what = "planned stances in which a foot never touched the ground",
       .unit = "1",
       .verb = "misses stances:",
       .note = "",
       .value =
           [](const Measurements& run) {
             double sum = 0.0;
             for (const auto& foot : run.feet) sum += foot.missed;
             return sum;
           },
       .worst = worst_feet([](const FootMeasures& foot) -> double { return foot.missed; })},
      {.name = "tracking",
       .what = "joint angles off their targets, root of the mean square",
       .unit = "rad",
       .verb = "tracks its targets within",
       .note = "",
       .value = [](const Measurements& run) { return run.tracking_rms; },
       .worst = worst_joints([](const JointMetrics& joint) { return joint.tracking_rms; })},
      {.name = "torque_peak_share",
       .what = "greatest torque of a servo over its limit",
       .unit = "1",
       .verb = "needs at its peak",
       .note = "of a servo's torque limit",
       .told = Told::percent,
       .value = peak_torque_share,
       .worst = worst_joints(torque_share)},
      {.name = "torque_rms",
       .what = "torque of the servos, root of the mean square",
       .unit = "N m",
       .verb = "needs",
       .note = "",
       .value = [](const Measurements& run) { return run.torque_rms; },
       .worst = worst_joints([](const JointMetrics& joint) { return joint.torque_rms; })},
      {.name = "power",
       .what = "mean positive mechanical power of the servos",
       .unit = "W",
       .verb = "spends",
       .note = "",
       .value = [](const Measurements& run) { return run.power_mean; }},
      {.name = "cost_of_transport",
       .what = "mechanical power over weight and speed",
       .unit = "1",
       .verb = "has a cost of transport of",
       .note = "",
       .asked = travels,
       .value = [](const Measurements& run) { return run.cost_of_transport; }},
      {.name = "penetration",
       .what = "how deep a contact sinks into the ground",
       .unit = "m",
       .verb = "sinks into the ground by",
       .note = "",
       .value = [](const Measurements& run) { return run.penetration_max; }},
  };
}

}  // namespace

const std::vector<LimitedQuantity>& limited_quantities() {
  static const std::vector<LimitedQuantity> all = [] {
    std::vector<LimitedQuantity> out = judged_by_default();
    for (auto& quantity : judged_if_asked()) out.push_back(std::move(quantity));
    return out;
  }();
  return all;
}

}  // namespace legwright
