// SPDX-License-Identifier: Apache-2.0
#include "plugin/pd_playback.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "plugin/numbers.hpp"
#include "plugin/playback_config.hpp"
#include "plugin/spline.hpp"

namespace legwright {
namespace {

/// MuJoCo saves models with six digits by default; the plugin's own attributes keep all of theirs.
constexpr double kGainTolerance = 1e-5;

std::string name_of(const mjModel* m, mjtObj type, int id) {
  const char* const name = mj_id2name(m, type, id);
  return name == nullptr || *name == '\0' ? fmt::format("#{}", id) : quoted(name);
}

template <typename... Args>
[[noreturn]] void refuse(const mjModel* m, int actuator, fmt::format_string<Args...> format,
                         Args&&... args) {
  throw ConfigError("actuator " + name_of(m, mjOBJ_ACTUATOR, actuator) + ": " +
                    fmt::format(format, std::forward<Args>(args)...));
}

/// The hinge that the actuator drives, by itself or through its tendon.
int joint_of(const mjModel* m, int actuator, std::optional<HingeLength>& length) {
  const int transmission = m->actuator_trntype[actuator], target = m->actuator_trnid[2 * actuator];
  if (transmission == mjTRN_TENDON) {
    try {
      length = hinge_length(m, target);
      return length->joint;
    } catch (const std::invalid_argument& error) {
      refuse(m, actuator, "tendon {} {}", name_of(m, mjOBJ_TENDON, target), error.what());
    }
  }
  if (transmission != mjTRN_JOINT && transmission != mjTRN_JOINTINPARENT) {
    refuse(m, actuator, "expected joint= or tendon=, the servo of legwright.gait turns a hinge");
  }
  if (m->jnt_type[target] != mjJNT_HINGE) {
    refuse(m, actuator, "joint {} is not a hinge", name_of(m, mjOBJ_JOINT, target));
  }
  return target;
}

/// What the servo law does not know, it must not pretend to honour.
void check_plain(const mjModel* m, int actuator) {
  const double gear = m->actuator_gear[6 * m->actuator_outadr[actuator]];
  if (gear != 1.0)
    refuse(m, actuator, "gear = {}, expected 1: kp and kd are gains at the joint or tendon", gear);
  if (m->actuator_ctrlnum[actuator] != 1) {
    refuse(m, actuator, "{} controls, expected 1 (the offset of the target)",
           m->actuator_ctrlnum[actuator]);
  }
  if (m->actuator_actnum[actuator] != 0)
    refuse(m, actuator, "has activation states, expected dyntype none");
  if (m->actuator_delay[actuator] != 0.0)
    refuse(m, actuator, "has a delay, which legwright.gait cannot honour");
}

bool agree(double a, double b) { return std::abs(a - b) <= kGainTolerance * std::abs(b); }

/// The engine takes the derivative of this servo from biasprm (README.md): it must tell the same
/// gains.
void check_bias(const mjModel* m, int actuator, double kp, double kd) {
  const double* const bias = m->actuator_biasprm + mjNBIAS * actuator;
  if (m->actuator_biastype[actuator] == mjBIAS_AFFINE && bias[0] == 0.0 && agree(bias[1], -kp) &&
      agree(bias[2], -kd)) {
    return;
  }
  const std::string found = m->actuator_biastype[actuator] == mjBIAS_AFFINE
                                ? fmt::format("biasprm \"{} {} {}\"", bias[0], bias[1], bias[2])
                                : std::string("no affine bias");
  refuse(m, actuator,
         "{}, but kp = {}, kd = {}; give its default class <general biastype=\"affine\" "
         "biasprm=\"0 {} {}\"/>",
         found, kp, kd, -kp, -kd);
}

/// Column of the joint's targets in the trajectory.
int joint_index(const mjModel* m, int actuator, int joint, const Trajectory& trajectory) {
  const char* const name = mj_id2name(m, mjOBJ_JOINT, joint);
  const auto& names = trajectory.joint_names;
  const auto found = std::find(names.begin(), names.end(), name == nullptr ? "" : name);
  if (found == names.end()) {
    refuse(m, actuator, "the trajectory has no column for joint {}",
           name_of(m, mjOBJ_JOINT, joint));
  }
  return static_cast<int>(found - names.begin());
}

/// A sensor shows the whole instance; what it says beyond that would be ignored.
void check_sensors(const mjModel* m, int instance) {
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] == instance && m->sensor_objtype[sensor] != mjOBJ_UNKNOWN) {
      throw ConfigError("sensor " + name_of(m, mjOBJ_SENSOR, sensor) +
                        ": expected no objtype: it has a value for each actuator of the instance");
    }
  }
}

bool disabled(const mjModel* m, int actuator) {
  constexpr int kSwitches = 31;  // bits of disableactuator; higher groups cannot be disabled
  const int group = m->actuator_group[actuator];
  return group >= 0 && group < kSwitches && (m->opt.disableactuator & (1 << group)) != 0;
}

}  // namespace

int servo_count(const mjModel* m, int instance) noexcept {
  return static_cast<int>(
      std::count(m->actuator_plugin, m->actuator_plugin + m->nactuator, instance));
}

PdPlayback::PdPlayback(const mjModel* m, int instance) {
  const int count = servo_count(m, instance);
  if (count == 0)
    throw ConfigError(
        "no actuator refers to this instance; expected one for each joint to be moved");
  check_sensors(m, instance);
  const PlaybackConfig config = read_config(m, instance, count);
  trajectory_ = config.trajectory;
  start_time_ = config.t0;

  std::vector<int> actuator_of(trajectory_->joint_names.size(), -1);
  for (int actuator = 0; actuator < m->nactuator; ++actuator) {
    if (m->actuator_plugin[actuator] != instance) continue;
    std::optional<HingeLength> length;
    const int joint = joint_of(m, actuator, length);
    check_plain(m, actuator);
    const int index = joint_index(m, actuator, joint, *trajectory_);
    int& other = actuator_of[static_cast<std::size_t>(index)];
    if (other >= 0) {
      refuse(m, actuator, "joint {} is driven by actuator {} already",
             name_of(m, mjOBJ_JOINT, joint), name_of(m, mjOBJ_ACTUATOR, other));
    }
    other = actuator;
    const double kp = config.kp[servos_.size()], kd = config.kd[servos_.size()];
    check_bias(m, actuator, kp, kd);
    servos_.push_back({actuator, joint, trajectory_->target_column(index),
                       trajectory_->torque_column(index), kp, kd, length});
  }
  const auto idle = std::find(actuator_of.begin(), actuator_of.end(), -1);
  if (idle != actuator_of.end()) {
    const auto& name =
        trajectory_->joint_names[static_cast<std::size_t>(idle - actuator_of.begin())];
    throw ConfigError(fmt::format(
        "the trajectory moves joint {}, but no actuator of the instance does", quoted(name)));
  }
}

void PdPlayback::apply_torque(const mjModel* m, mjData* d) const noexcept {
  const Trajectory& trajectory = *trajectory_;
  const SplinePhase phase = phase_at(trajectory, d->time + start_time_);
  for (const Servo& servo : servos_) {
    const int out = m->actuator_outadr[servo.actuator];
    if (disabled(m, servo.actuator)) {
      d->actuator_force[out] = 0.0;  // the engine leaves this to plugins
      continue;
    }
    const SplinePoint target = spline_point(trajectory, phase, servo.column);
    const double offset = d->ctrl[m->actuator_ctrladr[servo.actuator]];
    double length = target.value, rate = target.rate;
    double forward = linear_value(trajectory, phase, servo.torque_column);
    if (servo.length) {
      const double arm = servo.length->arm(target.value);
      length = servo.length->length(target.value);
      rate *= arm;
      forward = arm != 0.0 ? forward / arm : 0.0;
    }
    d->actuator_force[out] = servo.kp * (length + offset - d->actuator_length[out]) +
                             servo.kd * (rate - d->actuator_velocity[out]) + forward;
  }
}

void PdPlayback::measure_tracking_error(const mjModel* m, mjData* d, int instance) const noexcept {
  const SplinePhase phase = phase_at(*trajectory_, d->time + start_time_);
  for (int sensor = 0; sensor < m->nsensor; ++sensor) {
    if (m->sensor_plugin[sensor] != instance) continue;
    mjtNum* const error = d->sensordata + m->sensor_adr[sensor];
    const auto count = std::min(servos_.size(), static_cast<std::size_t>(m->sensor_dim[sensor]));
    for (std::size_t i = 0; i < count; ++i) {
      const double target = spline_point(*trajectory_, phase, servos_[i].column).value;
      error[i] = target - d->qpos[m->jnt_qposadr[servos_[i].joint]];
    }
  }
}

}  // namespace legwright
