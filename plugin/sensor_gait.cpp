// SPDX-License-Identifier: Apache-2.0
#include "plugin/sensor_gait.hpp"

#include <algorithm>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/number_text.hpp"
#include "plugin/pd_playback.hpp"
#include "plugin/playback_config.hpp"
#include "plugin/robot_names.hpp"

namespace legwright {
namespace {

std::vector<int> gait_instances(const mjModel* m, int gait_slot) {
  std::vector<int> instances;
  for (int i = 0; i < m->nplugin; ++i)
    if (m->plugin[i] == gait_slot) instances.push_back(i);
  return instances;
}

/// Name of the first sensor of the instance, else the instance's own; empty where neither has one.
std::string_view sensor_name(const mjModel* m, int instance) {
  const char* name = nullptr;
  for (int s = 0; s < m->nsensor && name == nullptr; ++s)
    if (m->sensor_plugin[s] == instance) name = mj_id2name(m, mjOBJ_SENSOR, s);
  if (name == nullptr || *name == '\0') name = mj_id2name(m, mjOBJ_PLUGIN, instance);
  return name == nullptr ? std::string_view() : std::string_view(name);
}

/// How the scene renamed the robot of a gait; not at all where that cannot be told.
RobotNames names_of_gait(const mjModel* m, int gait) {
  try {
    return robot_names(m, gait, read_trajectory(m, gait)->joint_names);
  } catch (const std::exception&) {
    return {};
  }
}

bool cannot_be_played(const mjModel* m, int gait) {
  try {
    const PdPlayback playback(m, gait);
    return false;
  } catch (const std::exception&) {
    return true;
  }
}

/// How many characters the scene put round the names of both the sensor and the gait, −1 where the
/// sensor is of another robot, or the gait has another name than `key` (if that is not empty).
int common_renaming(const mjModel* m, std::string_view sensor, int gait, std::string_view key) {
  const RobotNames robot = names_of_gait(m, gait);
  const auto length = [](const RobotNames& names) {
    return static_cast<int>(names.prefix.size() + names.suffix.size());
  };
  if (key.empty()) return robot.hold(sensor) ? length(robot) : -1;
  const char* const text = mj_id2name(m, mjOBJ_PLUGIN, gait);
  const std::string_view name = text == nullptr ? "" : text;
  int longest = -1;
  for (std::size_t at = name.find(key); at != std::string_view::npos; at = name.find(key, at + 1)) {
    const RobotNames more{std::string(name.substr(0, at)),
                          std::string(name.substr(at + key.size()))};
    if (more.hold(sensor) && robot.prefix.starts_with(more.prefix) &&
        robot.suffix.ends_with(more.suffix))
      longest = std::max(longest, length(more));
  }
  return longest;
}

}  // namespace

int find_gait(const mjModel* m, int instance, int gait_slot) {
  const std::string_view key = attribute(m, instance, "gait");
  const std::vector<int> gaits = gait_instances(m, gait_slot);
  if (key.empty() && gaits.size() == 1) return gaits.front();
  const std::string_view sensor = sensor_name(m, instance);
  int found = -1, longest = -1;
  for (const int gait : gaits) {
    const int renaming = common_renaming(m, sensor, gait, key);
    if (renaming < longest || renaming < 0) continue;
    found = renaming > longest ? gait : -1;  // two that fit alike: neither
    longest = renaming;
  }
  if (found >= 0) return found;
  const auto faulty =
      std::find_if(gaits.begin(), gaits.end(), [&](int gait) { return cannot_be_played(m, gait); });
  if (faulty != gaits.end()) return *faulty;
  if (!key.empty())
    throw ConfigError("gait: no instance of legwright.gait is named " + quoted(key));
  if (gaits.empty()) throw ConfigError("the model has no instance of legwright.gait to look at");
  throw ConfigError("gait is missing; the model has several instances of legwright.gait");
}

}  // namespace legwright
