// SPDX-License-Identifier: Apache-2.0
#include "plugin/sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "plugin/model_feet.hpp"
#include "plugin/number_text.hpp"
#include "plugin/planned_motion.hpp"
#include "plugin/sensor_gait.hpp"

namespace legwright {
namespace {

constexpr std::array kKinds = {std::pair{"phase", SensorKind::phase},
                               std::pair{"planned_contact", SensorKind::planned_contact},
                               std::pair{"measured_contact", SensorKind::measured_contact},
                               std::pair{"tracking_error", SensorKind::tracking_error},
                               std::pair{"base_error", SensorKind::base_error},
                               std::pair{"torque_share", SensorKind::torque_share}};

SensorKind read_kind(const mjModel* m, int instance) {
  const std::string_view text = attribute(m, instance, "kind");
  std::string names;
  for (const auto& [name, kind] : kKinds) {
    if (text == name) return kind;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  if (text.empty()) throw ConfigError("kind is missing; expected one of " + names);
  throw ConfigError("kind: got " + quoted(text) + ", expected one of " + names);
}

bool of_feet(SensorKind kind) {
  return kind == SensorKind::planned_contact || kind == SensorKind::measured_contact;
}

/// Throws what read_trajectory throws.
int size_of(const mjModel* m, SensorKind kind, int gait) {
  if (kind == SensorKind::phase) return 1;
  if (kind == SensorKind::base_error) return 6;
  return of_feet(kind) ? read_trajectory(m, gait)->foot_count() : servo_count(m, gait);
}

/// Share of a range that a force takes up in its own direction.
double share_of(const mjtNum* range, double force) {
  const double limit = force >= 0.0 ? range[1] : -range[0];
  if (limit > 0.0) return std::abs(force) / limit;
  return force == 0.0 ? 0.0 : 1.0;
}

/// Share of what a motor has left at its speed; one beyond the speed at which it has nothing.
double share_of_line(const Servo& servo, double force, double velocity) {
  const mjtNum range[2] = {servo.least(velocity), servo.most(velocity)};
  return force <= range[0] || force >= range[1] ? 1.0 : share_of(range, force);
}

void write_torque_share(const mjModel* m, const mjData* d, const PdPlayback& playback,
                        mjtNum* out) {
  for (const Servo& servo : playback.servos()) {
    const int at = m->actuator_outadr[servo.actuator];
    const double force = d->actuator_force[at];
    double share = share_of_line(servo, force, d->actuator_velocity[at]);
    if (m->actuator_forcelimited[servo.actuator])
      share = std::max(
          share, share_of(m->actuator_forcerange + std::ptrdiff_t{2} * servo.actuator, force));
    if (m->jnt_actfrclimited[servo.joint]) {
      share = std::max(share, share_of(m->jnt_actfrcrange + std::ptrdiff_t{2} * servo.joint,
                                       d->qfrc_actuator[m->jnt_dofadr[servo.joint]]));
    }
    *out++ = share;
  }
}

/// Planned less measured root: position, then the rotation vector of plan · measured⁻¹, world axes.
void write_base_error(const mjModel* m, const mjData* d, const PdPlayback& playback, mjtNum* out) {
  const Robot robot = robot_of(m, playback);
  if (robot.root_qpos < 0) return;
  const Pose plan = PlannedMotion(playback.trajectory()).root(playback.phase(d->time));
  const Pose here = measured_root(d, robot);
  mju_sub3(out, plan.position.data(), here.position.data());
  mjtNum back[4], turn[4];
  mju_negQuat(back, here.quaternion.data());
  mju_mulQuat(turn, plan.quaternion.data(), back);
  mju_quat2Vel(out + 3, turn, 1.0);
}

void write_measured_contact(const mjModel* m, const mjData* d, const std::vector<int>& foot_of_geom,
                            mjtNum* out) {
  for (int contact = 0; contact < d->ncon; ++contact) {
    int foot = -1;
    if (foot_contact_force(m, d, contact, foot_of_geom, foot) > 0.0) out[foot] = 1.0;
  }
}

double phase_share(const PdPlayback& playback, double time) {
  const Trajectory& t = playback.trajectory();
  const SplinePhase phase = playback.phase(time);
  return (phase.knot[1] + phase.fraction) / t.knot_count;
}

}  // namespace

void write_tracking_error(const mjModel* m, const mjData* d, const PdPlayback& playback,
                          mjtNum* out) noexcept {
  const SplinePhase phase = playback.phase(d->time);
  const Blend blend = blend_at(playback.clock(), d->time);
  for (const Servo& servo : playback.servos()) {
    *out++ = playback.target(servo, phase, blend).position - d->qpos[m->jnt_qposadr[servo.joint]];
  }
}

int sensor_size(const mjModel* m, int instance, int gait_slot) noexcept {
  try {
    const SensorKind kind = read_kind(m, instance);
    return std::max(1, size_of(m, kind, find_gait(m, instance, gait_slot)));
  } catch (...) {
    return 1;
  }
}

GaitSensor::GaitSensor(const mjModel* m, int instance, int gait_slot)
    : kind_(read_kind(m, instance)), gait_(find_gait(m, instance, gait_slot)) {
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] == instance) sensors_.push_back(sensor);
  }
  std::optional<PdPlayback> playback;
  try {
    size_ = size_of(m, kind_, gait_);
    if (kind_ == SensorKind::base_error || kind_ == SensorKind::measured_contact)
      playback.emplace(m, gait_);
  } catch (const std::exception&) {
    return;  // the gait's own init tells the reason
  }
  if (of_feet(kind_) && size_ == 0)
    throw ConfigError("the trajectory has no foot whose contact could be told");
  if (kind_ == SensorKind::base_error && robot_of(m, *playback).root_qpos < 0)
    throw ConfigError("the robot has no free joint, so that its base cannot leave the plan");
  if (kind_ == SensorKind::measured_contact) {
    const std::vector<std::string>& feet = playback->trajectory().foot_names;
    foot_of_geom_ = feet_by_geom(m, find_feet(m, playback->names().in_scene(feet)));
  }
}

void GaitSensor::measure(const mjModel* m, mjData* d, const PdPlayback& playback) const noexcept {
  for (const int sensor : sensors_) {
    mjtNum* const out = d->sensordata + m->sensor_adr[sensor];
    std::fill_n(out, m->sensor_dim[sensor], 0.0);
    if (m->sensor_dim[sensor] == size_) write(m, d, playback, out);
  }
}

void GaitSensor::write(const mjModel* m, const mjData* d, const PdPlayback& playback,
                       mjtNum* out) const noexcept {
  switch (kind_) {
    case SensorKind::phase:
      *out = phase_share(playback, d->time);
      return;
    case SensorKind::planned_contact: {
      const PlannedMotion plan(playback.trajectory());
      const SplinePhase phase = playback.phase(d->time);
      for (int foot = 0; foot < playback.trajectory().foot_count(); ++foot)
        out[foot] = plan.contact(phase, foot) ? 1.0 : 0.0;
      return;
    }
    case SensorKind::measured_contact:
      return write_measured_contact(m, d, foot_of_geom_, out);
    case SensorKind::tracking_error:
      return write_tracking_error(m, d, playback, out);
    case SensorKind::base_error:
      return write_base_error(m, d, playback, out);
    case SensorKind::torque_share:
      return write_torque_share(m, d, playback, out);
  }
}

}  // namespace legwright
