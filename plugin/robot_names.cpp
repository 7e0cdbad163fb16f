// SPDX-License-Identifier: Apache-2.0
#include "plugin/robot_names.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "plugin/hinge_length.hpp"

namespace legwright {
namespace {

std::string_view scene_name(const mjModel* m, mjtObj type, int id) {
  const char* const name = id < 0 ? nullptr : mj_id2name(m, type, id);
  return name == nullptr ? std::string_view() : std::string_view(name);
}

/// −1 where the actuator drives none: bind_servos tells why that is wrong.
int driven_joint(const mjModel* m, int actuator) {
  const int transmission = m->actuator_trntype[actuator],
            target = m->actuator_trnid[std::ptrdiff_t{2} * actuator];
  if (transmission == mjTRN_JOINT || transmission == mjTRN_JOINTINPARENT)
    return target >= 0 && target < m->njnt ? target : -1;
  if (transmission != mjTRN_TENDON || target < 0 || target >= m->ntendon) return -1;
  try {
    return hinge_length(m, target).joint;
  } catch (const std::invalid_argument&) {
    return -1;
  }
}

bool is_column(const std::vector<std::string>& columns, std::string_view name) {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

/// How many of the joints are columns under these names.
std::size_t fitting(const RobotNames& names, const std::vector<std::string_view>& joints,
                    const std::vector<std::string>& columns) {
  return static_cast<std::size_t>(
      std::count_if(joints.begin(), joints.end(), [&](std::string_view joint) {
        return names.hold(joint) && is_column(columns, names.within(joint));
      }));
}

}  // namespace

std::string RobotNames::in_scene(std::string_view name) const {
  return prefix + std::string(name) + suffix;
}

std::vector<std::string> RobotNames::in_scene(const std::vector<std::string>& names) const {
  std::vector<std::string> found;
  found.reserve(names.size());
  for (const std::string& name : names) found.push_back(in_scene(name));
  return found;
}

bool RobotNames::hold(std::string_view name) const {
  return name.size() >= prefix.size() + suffix.size() && name.starts_with(prefix) &&
         name.ends_with(suffix);
}

std::string_view RobotNames::within(std::string_view name) const {
  return name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
}

RobotNames robot_names(const mjModel* m, int instance,
                       const std::vector<std::string>& joint_names) {
  std::vector<std::string_view> joints, renamed = {scene_name(m, mjOBJ_PLUGIN, instance)};
  for (int actuator = 0; actuator < m->nactuator; ++actuator) {
    if (m->actuator_plugin[actuator] != instance) continue;
    joints.push_back(scene_name(m, mjOBJ_JOINT, driven_joint(m, actuator)));
    renamed.push_back(scene_name(m, mjOBJ_ACTUATOR, actuator));
  }
  RobotNames best;
  std::size_t most = fitting(best, joints, joint_names);
  for (std::size_t j = 0; j < joints.size() && most < joints.size(); ++j) {
    for (const std::string& column : joint_names) {
      for (std::size_t at = joints[j].rfind(column); at != std::string_view::npos;
           at = at == 0 ? std::string_view::npos : joints[j].rfind(column, at - 1)) {
        const RobotNames names{std::string(joints[j].substr(0, at)),
                               std::string(joints[j].substr(at + column.size()))};
        const std::size_t fit = fitting(names, joints, joint_names);
        const bool all = std::all_of(renamed.begin(), renamed.end(), [&](std::string_view name) {
          return name.empty() || names.hold(name);
        });
        if (fit <= most || !all) continue;
        best = names;
        most = fit;
      }
    }
  }
  return best;
}

}  // namespace legwright
