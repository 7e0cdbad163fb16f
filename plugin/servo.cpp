// SPDX-License-Identifier: Apache-2.0
#include "plugin/servo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "plugin/number_text.hpp"

namespace legwright {
namespace {

/// MuJoCo saves models with six digits by default; the plugin's own attributes keep all of theirs.
constexpr double kGainTolerance = 1e-5;

template <typename... Args>
[[noreturn]] void refuse_actuator(const mjModel* m, int actuator,
                                  fmt::format_string<Args...> format, Args&&... args) {
  throw ConfigError("actuator " + name_of(m, mjOBJ_ACTUATOR, actuator) + ": " +
                    fmt::format(format, std::forward<Args>(args)...));
}

/// The joint that the actuator drives, by itself or through its tendon.
int joint_of(const mjModel* m, int actuator, std::optional<HingeLength>& length) {
  const int transmission = m->actuator_trntype[actuator],
            target = m->actuator_trnid[std::ptrdiff_t{2} * actuator];
  const auto check_range = [&](mjtSize count) {
    if (target < 0 || target >= count)
      refuse_actuator(m, actuator, "trnid = {}, expected 0 to {}", target, count - 1);
  };
  if (transmission == mjTRN_TENDON) {
    check_range(m->ntendon);
    try {
      length = hinge_length(m, target);
      return length->joint;
    } catch (const std::invalid_argument& error) {
      refuse_actuator(m, actuator, "tendon {} {}", name_of(m, mjOBJ_TENDON, target), error.what());
    }
  }
  if (transmission != mjTRN_JOINT && transmission != mjTRN_JOINTINPARENT) {
    refuse_actuator(m, actuator,
                    "expected joint=, jointinparent= or tendon=: legwright.gait moves joints");
  }
  check_range(m->njnt);
  if (m->jnt_type[target] != mjJNT_HINGE && m->jnt_type[target] != mjJNT_SLIDE) {
    refuse_actuator(m, actuator, "joint {} is neither a hinge nor a slide",
                    name_of(m, mjOBJ_JOINT, target));
  }
  return target;
}

/// What the servo law does not know, it must not pretend to honour.
void check_plain(const mjModel* m, int actuator) {
  const double gear = m->actuator_gear[std::ptrdiff_t{6} * m->actuator_outadr[actuator]];
  if (gear != 1.0)
    refuse_actuator(m, actuator,
                    "gear = {}, expected 1: kp and kd are gains at the joint or tendon", gear);
  if (m->actuator_ctrlnum[actuator] != 1) {
    refuse_actuator(m, actuator, "{} controls, expected 1 (the offset of the target)",
                    m->actuator_ctrlnum[actuator]);
  }
  if (m->actuator_actnum[actuator] != 0)
    refuse_actuator(m, actuator, "has activation states, expected dyntype none");
  if (m->actuator_delay[actuator] != 0.0)
    refuse_actuator(m, actuator, "has a delay, which legwright.gait cannot honour");
}

bool agree(double a, double b) { return std::abs(a - b) <= kGainTolerance * std::abs(b); }

/// The engine takes the derivative of this servo from biasprm (README.md): it must tell the same
/// gains.
void check_bias(const mjModel* m, int actuator, double kp, double kd) {
  const double* const bias = m->actuator_biasprm + std::ptrdiff_t{mjNBIAS} * actuator;
  if (m->actuator_biastype[actuator] == mjBIAS_AFFINE && bias[0] == 0.0 && agree(bias[1], -kp) &&
      agree(bias[2], -kd)) {
    return;
  }
  const std::string found = m->actuator_biastype[actuator] == mjBIAS_AFFINE
                                ? fmt::format("biasprm \"{} {} {}\"", bias[0], bias[1], bias[2])
                                : std::string("no affine bias");
  refuse_actuator(m, actuator,
                  "{}, but kp = {}, kd = {}; give its default class <general biastype=\"affine\" "
                  "biasprm=\"0 {} {}\"/>",
                  found, kp, kd, -kp, -kd);
}

/// Tells of the prefix, if any, why the names of model and trajectory differ.
std::string attached_as(const RobotNames& names) {
  if (names.prefix.empty() && names.suffix.empty()) return "";
  return fmt::format(" (the robot is attached with prefix {} and suffix {})", quoted(names.prefix),
                     quoted(names.suffix));
}

/// Where the joint's targets are in the trajectory.
int joint_index(const mjModel* m, int actuator, int joint, const PlaybackConfig& config) {
  const Trajectory& trajectory = *config.trajectory;
  const char* const text = mj_id2name(m, mjOBJ_JOINT, joint);
  const std::string_view name = text == nullptr ? "" : text;
  const auto& columns = trajectory.joint_names;
  const auto found = config.names.hold(name)
                         ? std::find(columns.begin(), columns.end(), config.names.within(name))
                         : columns.end();
  if (found == columns.end()) {
    refuse_actuator(m, actuator, "the trajectory has no column for joint {}{}",
                    name_of(m, mjOBJ_JOINT, joint), attached_as(config.names));
  }
  const int index = static_cast<int>(found - columns.begin());
  const bool slides = m->jnt_type[joint] == mjJNT_SLIDE;
  if (slides != trajectory.slides(index)) {
    refuse_actuator(m, actuator, "joint {} is a {}, but its column is {}; expected q:{} and tau:{}",
                    name_of(m, mjOBJ_JOINT, joint), slides ? "slide" : "hinge",
                    trajectory.header()[static_cast<std::size_t>(trajectory.target_column(index))],
                    *found + (slides ? "_m" : "_rad"), *found + (slides ? "_N" : "_Nm"));
  }
  return index;
}

void set_rest(const mjModel* m, int instance, const PlaybackConfig& config,
              std::vector<Servo>& servos) {
  const mjtNum* const qpos = read_rest(m, instance, config.names);
  for (Servo& servo : servos) {
    servo.rest = qpos[m->jnt_qposadr[servo.joint]];
    if (config.clock.blend_in > 0.0 && !(std::abs(servo.rest) <= kLargestNumber)) {
      refuse_actuator(m, servo.actuator,
                      "joint {} is at {} in the rest pose, expected a finite number",
                      name_of(m, mjOBJ_JOINT, servo.joint), servo.rest);
    }
  }
}

}  // namespace

std::string name_of(const mjModel* m, mjtObj type, int id) {
  const char* const name = mj_id2name(m, type, id);
  return name == nullptr || *name == '\0' ? fmt::format("#{}", id) : quoted(name);
}

double Servo::most(double velocity) const noexcept {
  if (no_load_speed == 0.0) return std::numeric_limits<double>::infinity();
  return stall_torque * (1.0 - velocity / no_load_speed);
}

int servo_count(const mjModel* m, int instance) noexcept {
  return static_cast<int>(
      std::count(m->actuator_plugin, m->actuator_plugin + m->nactuator, instance));
}

std::vector<Servo> bind_servos(const mjModel* m, int instance, const PlaybackConfig& config) {
  const Trajectory& trajectory = *config.trajectory;
  std::vector<Servo> servos;
  std::vector<int> actuator_of(trajectory.joint_names.size(), -1);
  for (int actuator = 0; actuator < m->nactuator; ++actuator) {
    if (m->actuator_plugin[actuator] != instance) continue;
    std::optional<HingeLength> length;
    const int joint = joint_of(m, actuator, length);
    check_plain(m, actuator);
    const int index = joint_index(m, actuator, joint, config);
    int& other = actuator_of[static_cast<std::size_t>(index)];
    if (other >= 0) {
      refuse_actuator(m, actuator, "joint {} is driven by actuator {} already",
                      name_of(m, mjOBJ_JOINT, joint), name_of(m, mjOBJ_ACTUATOR, other));
    }
    other = actuator;
    const double kp = config.kp[servos.size()], kd = config.kd[servos.size()];
    check_bias(m, actuator, kp, kd);
    servos.push_back({actuator, joint, trajectory.target_column(index),
                      trajectory.torque_column(index), kp, kd, 0.0, length,
                      config.stall_torque[servos.size()], config.no_load_speed[servos.size()]});
  }
  const auto idle = std::find(actuator_of.begin(), actuator_of.end(), -1);
  if (idle != actuator_of.end()) {
    const auto& name = trajectory.joint_names[static_cast<std::size_t>(idle - actuator_of.begin())];
    throw ConfigError(
        fmt::format("the trajectory moves joint {}, but no actuator of the instance does{}",
                    quoted(name), attached_as(config.names)));
  }
  set_rest(m, instance, config, servos);
  return servos;
}

}  // namespace legwright
