// SPDX-License-Identifier: Apache-2.0
#include "tools/task/facing_warnings.hpp"

#include <fmt/format.h>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/limbs.hpp"
#include "optimizer/motion/faced_frame.hpp"

namespace legwright {
namespace {

/// The first design parameter with a target that mirrors another across an axis; null: none.
const DesignParameter* tied_across(const RobotModel& robot, Across across) {
  for (std::size_t k = 0; k < robot.bindings.size(); ++k)
    for (const Binding::Target& target : robot.bindings[k].targets)
      if (target.mirror == across) return &robot.space.parameters[k];
  return nullptr;
}

}  // namespace

std::vector<std::string> facing_warnings(const TaskFile& task, const RobotModel& robot) {
  std::vector<std::string> out;
  const Eigen::Vector2d forward = task.forward;
  const std::string faces = facing_text(forward);
  if (const Facing found = facing_of(robot);
      !found.known.empty() && found.ahead != forward && forward == Eigen::Vector2d::UnitX())
    out.push_back(fmt::format(
        "{}, so it seems to face {} of its trunk's frame, and this task has it face {}; forward = "
        "\"{}\" in [travel] turns the task",
        found.known, facing_text(found.ahead), faces, facing_text(found.ahead)));
  const Across sides = sides_across(forward), along = sides == Across::y ? Across::x : Across::y;
  const DesignParameter* tied = tied_across(robot, along);
  if (tied != nullptr && tied_across(robot, sides) == nullptr)
    out.push_back(fmt::format(
        "the file's design parameters, '{}' first, tie legs as mirror images across {}, and this "
        "task has the robot face {}, so front and hind change alike where left and right should; "
        "to have them for a robot that faces {}, take the lines \"legwright/...\" out of the "
        "file's <custom> section, then `legwright init {} --forward {} --write`",
        tied->name, along == Across::y ? "y" : "x", faces, faces, robot.file.filename().string(),
        faces));
  return out;
}

}  // namespace legwright
