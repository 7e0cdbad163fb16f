// SPDX-License-Identifier: Apache-2.0
#include "plugin/pd_playback.hpp"

#include <algorithm>

namespace legwright {
namespace {

bool disabled(const mjModel* m, int actuator) {
  constexpr int kSwitches = 31;  // bits of disableactuator; higher groups cannot be disabled
  const int group = m->actuator_group[actuator];
  return group >= 0 && group < kSwitches && (m->opt.disableactuator & (1 << group)) != 0;
}

}  // namespace

PdPlayback::PdPlayback(const mjModel* m, int instance) {
  const int count = servo_count(m, instance);
  if (count == 0)
    throw ConfigError(
        "no actuator refers to this instance; expected one for each joint to be moved");
  const PlaybackConfig config = read_config(m, instance, count);
  servos_ = bind_servos(m, instance, config);
  trajectory_ = config.trajectory;
  names_ = config.names;
  clock_ = config.clock;
  ff_ = config.ff;
  ghost_group_ = config.ghost_group;
}

PdPlayback::Target PdPlayback::target(const Servo& servo, const SplinePhase& phase,
                                      const Blend& blend) const noexcept {
  const SplinePoint gait = spline_point(*trajectory_, phase, servo.column);
  const double velocity = clock_.speed * gait.rate;
  if (blend.share == 1.0) return {gait.value, velocity};
  const double way = gait.value - servo.rest;
  return {servo.rest + blend.share * way, blend.share * velocity + blend.rate * way};
}

void PdPlayback::apply_torque(const mjModel* m, mjData* d) const noexcept {
  const SplinePhase phase = this->phase(d->time);
  const Blend blend = blend_at(clock_, d->time);
  for (const Servo& servo : servos_) {
    const int out = m->actuator_outadr[servo.actuator];
    if (disabled(m, servo.actuator)) {
      d->actuator_force[out] = 0.0;  // the engine leaves this to plugins
      continue;
    }
    const Target target = this->target(servo, phase, blend);
    const double offset = d->ctrl[m->actuator_ctrladr[servo.actuator]];
    double length = target.position, rate = target.velocity;
    double forward = ff_ * blend.share * linear_value(*trajectory_, phase, servo.torque_column);
    if (servo.length) {
      const double arm = servo.length->arm(target.position);
      length = servo.length->length(target.position);
      rate *= arm;
      forward = arm != 0.0 ? forward / arm : 0.0;
    }
    const double velocity = d->actuator_velocity[out];
    const double force = servo.kp * (length + offset - d->actuator_length[out]) +
                         servo.kd * (rate - velocity) + forward;
    d->actuator_force[out] = std::max(servo.least(velocity), std::min(force, servo.most(velocity)));
  }
}

}  // namespace legwright
