// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// How a scene calls what the configuration of an instance names. Attaching a robot to a scene
/// (mjs_attach) puts one prefix before and one suffix behind the names of all its parts, but leaves
/// the text of <config> as it was. Both are empty in a scene of one robot.
struct RobotNames {
  std::string prefix, suffix;

  std::string in_scene(std::string_view name) const;
  std::vector<std::string> in_scene(const std::vector<std::string>& names) const;
  /// Whether a name of the scene stands between prefix and suffix.
  bool hold(std::string_view name) const;
  /// What stands between them; only of a name that they hold.
  std::string_view within(std::string_view name) const;
};

/// The prefix and suffix under which the most joints of an instance are columns of its trajectory,
/// the empty ones where none is better. The instance and its actuators, where they have names, must
/// have them too: attaching renames all alike, and a robot that merely resembles another does not.
/// Where all joints fit and none is left out, the lengths of the names leave no second choice.
RobotNames robot_names(const mjModel* m, int instance, const std::vector<std::string>& joint_names);

}  // namespace legwright
