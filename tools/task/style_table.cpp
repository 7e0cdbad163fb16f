// SPDX-License-Identifier: Apache-2.0
#include "tools/task/style_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/refusals.hpp"
#include "optimizer/motion/faced_frame.hpp"

namespace legwright {
namespace {

std::vector<Eigen::Vector2d> vectors(const std::vector<std::vector<double>>& pairs) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(pairs.size());
  for (const std::vector<double>& pair : pairs) out.emplace_back(pair[0], pair[1]);
  return out;
}

bool is_array(const toml::node* node) { return node != nullptr && node->is_array(); }

/// Pairs of a file, which are so far ahead and to the left, in the frame of the robot's trunk.
std::vector<Eigen::Vector2d> in_trunk(std::vector<Eigen::Vector2d> pairs,
                                      const Eigen::Vector2d& forward) {
  for (Eigen::Vector2d& pair : pairs) pair = from_facing(pair, forward);
  return pairs;
}

std::optional<std::vector<Eigen::Vector2d>> footprint_of(const TaskFile& file,
                                                         const std::vector<int>& order) {
  if (file.footprint.empty()) return std::nullopt;
  const std::size_t foot_count = order.size();
  std::vector<Eigen::Vector2d> result(foot_count);
  if (file.footprint.size() == 1 &&
      foot_count > 1) {  // half length and half width: rows from front to hind
    if (foot_count % 2 != 0)
      file.refuse("style.footprint",
                  "half length and half width need an even number of feet; give a pair for each");
    const std::size_t row_count = foot_count / 2;
    const auto rows = static_cast<double>(row_count);
    for (std::size_t place = 0; place < foot_count; ++place) {
      const std::size_t row = place / 2;
      const double along = rows > 1 ? 1.0 - 2.0 * static_cast<double>(row) / (rows - 1.0) : 0.0;
      result[order[place]] = from_facing(
          file.footprint[0].cwiseProduct(Eigen::Vector2d(along, place % 2 == 0 ? 1.0 : -1.0)),
          file.forward);
    }
    return result;
  }
  if (file.footprint.size() != foot_count)
    file.refuse(
        "style.footprint",
        fmt::format("has {} pairs; the robot has {} feet: one pair each, front to hind, left "
                    "before right, or "
                    "[half length, half width]",
                    file.footprint.size(), foot_count));
  const std::vector<Eigen::Vector2d> places = in_trunk(file.footprint, file.forward);
  for (std::size_t place = 0; place < foot_count; ++place) result[order[place]] = places[place];
  return result;
}

/// Values that the file gives by name, in the order of the robot's names; those that it does not
/// give are as they are by default. @param what of the robot has the names: "foot", "joint"
template <class Value>
std::vector<Value> by_robots_names(const TaskFile& file, const std::string& key,
                                   const std::map<std::string, Value>& given,
                                   const std::vector<std::string>& names, std::string_view what,
                                   std::string_view all) {
  std::vector<Value> out;
  Refusals reasons;
  for (const auto& [name, value] : given) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const std::string guess = nearest(name, names);
      reasons.add(
          file.refusal(fmt::format("{}.{}", key, name),
                       fmt::format("the robot has no such {}; {}{} {}", what,
                                   guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                                   all, fmt::join(names, ", "))));
      continue;
    }
    out.resize(names.size());
    out[static_cast<std::size_t>(found - names.begin())] = value;
  }
  reasons.throw_if_any();
  return out;
}

std::vector<std::string> joint_names(const Morphology& morphology) {
  std::vector<std::string> names;
  names.reserve(morphology.links.size());
  for (int a = 0; a < morphology.joint_count(); ++a)
    names.push_back(morphology.links[a + 1].joint.name);
  return names;
}

/// A joint cannot be asked for an angle that it does not reach.
void check_joint_angles(const TaskFile& file, const RobotModel& robot, Refusals& reasons) {
  for (int a = 0; a < robot.morphology.joint_count(); ++a) {
    const Joint& joint = robot.morphology.links[a + 1].joint;
    const auto found = file.joint_angles.find(joint.name);
    if (found == file.joint_angles.end()) continue;
    for (const double angle : found->second.values)
      if (angle < joint.lower || angle > joint.upper)
        reasons.add(file.refusal(
            "style.joint_angles." + joint.name,
            fmt::format("asks for {} rad; the robot's file lets this joint turn from {:.4g} to "
                        "{:.4g} rad{}; write an angle in between, in rad",
                        angle, joint.lower, joint.upper,
                        robot.in_degrees
                            ? fmt::format(" ({})", angle_range_text(joint.lower, joint.upper, true))
                            : "")));
  }
}

}  // namespace

void read_style(TaskTable in, TaskFile& task) {
  if (is_array(in.node("com_height")))
    task.com_heights = in.numbers("com_height").value_or(std::vector<double>{});
  else if (in.has("com_height")) {  // else what stands outside [[task]] holds
    task.com_height = in.number("com_height");
    task.com_heights.clear();
  }
  if (const auto path = in.pairs("com_path")) task.com_path = vectors(*path);
  const toml::node* footprint = in.node("footprint");
  if (is_array(footprint) && !footprint->as_array()->empty() &&
      footprint->as_array()->get(0)->is_array()) {
    if (const auto pairs = in.pairs("footprint")) task.footprint = vectors(*pairs);
  } else if (const auto half = in.numbers("footprint")) {
    task.footprint = vectors({*half});
  }
  task.stance_width = in.number("stance_width").value_or(task.stance_width);
  for (const auto& [name, pairs] : in.pairs_by_name("foot_targets"))
    task.foot_targets[name] = vectors(pairs);
  for (const auto& [name, target] : in.targets_by_name("foot_heights"))
    task.foot_heights[name] = target;
  for (const auto& [name, target] : in.targets_by_name("joint_angles"))
    task.joint_angles[name] = target;
  in.finish();
}

void apply_style(const TaskFile& file, const RobotModel& robot, const std::vector<int>& order,
                 Task& task) {
  const Morphology& morphology = robot.morphology;
  std::vector<std::string> feet;
  for (const Foot& foot : morphology.feet) feet.push_back(foot.name);
  const std::vector<std::string> joints = joint_names(morphology);
  task.com_height = file.com_height;
  task.com_heights = file.com_heights;
  task.com_path = in_trunk(file.com_path, file.forward);
  Refusals reasons;
  reasons.collect([&] { task.footprint = footprint_of(file, order); });
  reasons.collect([&] {
    task.foot_targets = by_robots_names(file, "style.foot_targets", file.foot_targets, feet, "foot",
                                        "its feet are");
  });
  for (std::vector<Eigen::Vector2d>& places : task.foot_targets)
    places = in_trunk(std::move(places), file.forward);
  reasons.collect([&] {
    task.foot_heights = by_robots_names(file, "style.foot_heights", file.foot_heights, feet, "foot",
                                        "its feet are");
  });
  reasons.collect([&] {
    task.joint_angles = by_robots_names(file, "style.joint_angles", file.joint_angles, joints,
                                        "moving joint", "its joints are");
  });
  check_joint_angles(file, robot, reasons);
  reasons.throw_if_any();
}

double highest_swing(const Task& task, int foot) {
  double most = 0.0;
  for (int knot = 0; knot < task.gait.knot_count(); ++knot)
    if (!task.gait.planted(knot, foot, task.planted_margin))
      most = std::max(most, task.foot_heights[static_cast<std::size_t>(foot)].at(
                                static_cast<double>(knot) / task.gait.knot_count()));
  return most;
}

std::optional<double> highest_com(const Task& task) {
  if (task.com_heights.empty()) return task.com_height;
  return *std::max_element(task.com_heights.begin(), task.com_heights.end());
}

}  // namespace legwright
