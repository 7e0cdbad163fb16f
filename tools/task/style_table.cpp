// SPDX-License-Identifier: Apache-2.0
#include "tools/task/style_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/nearest_word.hpp"

namespace legwright {
namespace {

constexpr Range kReach{-5.0, 5.0, false, false, "m"};
constexpr Range kHeight{0.0, 5.0, true, false, "m"};

std::vector<Eigen::Vector2d> vectors(const std::vector<std::vector<double>>& pairs) {
  std::vector<Eigen::Vector2d> out;
  for (const std::vector<double>& pair : pairs) out.emplace_back(pair[0], pair[1]);
  return out;
}

bool is_array(const toml::node* node) { return node != nullptr && node->is_array(); }

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
    const auto rows = static_cast<double>(foot_count / 2);
    for (std::size_t place = 0; place < foot_count; ++place) {
      const double along =
          rows > 1 ? 1.0 - 2.0 * static_cast<double>(place / 2) / (rows - 1.0) : 0.0;
      result[order[place]] =
          file.footprint[0].cwiseProduct(Eigen::Vector2d(along, place % 2 == 0 ? 1.0 : -1.0));
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
  for (std::size_t place = 0; place < foot_count; ++place)
    result[order[place]] = file.footprint[place];
  return result;
}

std::vector<std::vector<Eigen::Vector2d>> foot_targets_of(const TaskFile& file,
                                                          const std::vector<std::string>& names) {
  std::vector<std::vector<Eigen::Vector2d>> targets;
  for (const auto& [name, places] : file.foot_targets) {
    const auto foot = std::find(names.begin(), names.end(), name);
    if (foot == names.end()) {
      const std::string guess = nearest(name, names);
      file.refuse("style.foot_targets." + name,
                  fmt::format("the robot has no such foot; {}its feet are {}",
                              guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                              fmt::join(names, ", ")));
    }
    targets.resize(names.size());
    targets[static_cast<std::size_t>(foot - names.begin())] = places;
  }
  return targets;
}

}  // namespace

void read_style(TableReader in, TaskFile& task) {
  if (is_array(in.node("com_height")))
    task.com_heights = in.numbers("com_height", kHeight, 0).value_or(std::vector<double>{});
  else if (in.has("com_height")) {  // else what stands outside [[task]] holds
    task.com_height = in.number("com_height", kHeight);
    task.com_heights.clear();
  }
  if (const auto path = in.pairs("com_path", kReach)) task.com_path = vectors(*path);
  const toml::node* footprint = in.node("footprint");
  if (is_array(footprint) && !footprint->as_array()->empty() &&
      footprint->as_array()->get(0)->is_array()) {
    if (const auto pairs = in.pairs("footprint", kReach)) task.footprint = vectors(*pairs);
  } else if (const auto half = in.numbers("footprint", {0.0, 5.0, false, false, "m"}, 2)) {
    task.footprint = vectors({*half});
  }
  for (const auto& [name, pairs] : in.pairs_by_name("foot_targets", kReach))
    task.foot_targets[name] = vectors(pairs);
  in.finish();
}

void apply_style(const TaskFile& file, const std::vector<std::string>& names,
                 const std::vector<int>& order, Task& task) {
  task.com_height = file.com_height;
  task.com_heights = file.com_heights;
  task.com_path = file.com_path;
  task.footprint = footprint_of(file, order);
  task.foot_targets = foot_targets_of(file, names);
}

std::optional<double> highest_com(const Task& task) {
  if (task.com_heights.empty()) return task.com_height;
  return *std::max_element(task.com_heights.begin(), task.com_heights.end());
}

}  // namespace legwright
