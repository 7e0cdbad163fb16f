// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <iterator>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "plugin/clock.hpp"
#include "plugin/robot_names.hpp"
#include "plugin/trajectory.hpp"

namespace legwright {

/// Thrown for a configuration that cannot be played; the message is meant for the user.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The keys of an instance's configuration, in the order in which they are registered: the long one
/// last, because MuJoCo looks a key up by reading over the values of all before it. Models that
/// mj_saveModel wrote hold values in this order.
inline constexpr const char* kAttributes[] = {
    "period",       "travel",        "turn",      "kp",       "kd",   "ff",
    "t0",           "phase",         "speed",     "blend_in", "rest", "ghost_group",
    "stall_torque", "no_load_speed", "trajectory"};
inline constexpr int kAttributeCount = static_cast<int>(std::size(kAttributes));

/// What the attributes of one instance say.
struct PlaybackConfig {
  std::shared_ptr<const Trajectory> trajectory;
  RobotNames names;
  std::vector<double> kp, kd;  // one for each servo [N·m/rad, N·m·s/rad]
  // One for each servo, zeros for those without a line: torque at rest [N·m] and speed without load
  // [rad/s].
  std::vector<double> stall_torque, no_load_speed;
  double ff = 1.0;  // scale of the feed-forward
  Clock clock;
  int ghost_group = 5;  // geom group whose switch shows the ghost
};

/// Reads the attributes of `instance`. The trajectory is parsed once per content, however many
/// instances, mjData and threads ask for it. Throws ConfigError or TrajectoryError.
PlaybackConfig read_config(const mjModel* m, int instance, int servo_count);

/// The rest pose of `instance`, a vector of the model: the keyframe that `rest` names, else the one
/// named "home", else the model's reference pose. Throws ConfigError.
const mjtNum* read_rest(const mjModel* m, int instance, const RobotNames& names);

/// The trajectory of `instance` only. Throws like read_config.
std::shared_ptr<const Trajectory> read_trajectory(const mjModel* m, int instance);

/// Value of a key of an instance; empty where it is not set.
std::string_view attribute(const mjModel* m, int instance, const char* key);

}  // namespace legwright
