// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/tightened_text.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

using Path = std::vector<std::string>;

/// Keys and their values, as a task file has them.
std::vector<std::pair<Path, std::optional<double>>> numbers_of(const TaskFile& file) {
  const Task& margins = file.margins;
  std::vector<std::pair<Path, std::optional<double>>> out = {
      {{"limits", "torque_margin"}, margins.torque_margin},
      {{"limits", "min_normal"}, margins.min_normal},
      {{"limits", "friction"}, margins.friction},
      {{"limits", "swing_height"}, margins.swing_height},
      {{"limits", "planted_margin"}, file.planted_margin},
      {{"travel", "aim_speed"}, file.aim_speed},
      {{"travel", "aim_turn_rate"}, file.aim_turn_rate},
      {{"style", "stance_width"}, file.stance_width}};
  for (const auto& [term, weight] : file.weights) out.push_back({{"weights", term}, weight});
  return out;
}

}  // namespace

std::string tightened_text(const CodesignProblem& problem,
                           const std::vector<Tightening>& tightening, const std::string& robot) {
  std::string text = with_key(problem.set.text, {"robot"}, fmt::format("\"{}\"", robot));
  for (int k = 0; k < problem.task_count(); ++k) {
    const auto before = numbers_of(tightened_file(problem, k, {}));  // every default by its number
    const auto after =
        numbers_of(tightened_file(problem, k, tightening[static_cast<std::size_t>(k)]));
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] == before[i]) continue;
      Path path = after[i].first;
      if (problem.set.joint()) path.insert(path.begin(), {"task", std::to_string(k)});
      text = with_key(text, path, fmt::format("{}", *after[i].second));
    }
  }
  return text;
}

}  // namespace legwright
