// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/tightened_text.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/task/task_file.hpp"
#include "tools/task/task_text.hpp"
#include "tools/task/toml_text.hpp"

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
  if (!parse_toml(text, problem.set.file).contains("name"))  // else that of the new file
    text = with_key(text, {"name"}, fmt::format("\"{}\"", problem.set.name));
  for (int k = 0; k < problem.task_count(); ++k) {
    const auto before = numbers_of(tightened_file(problem, k, {}));  // every default by its number
    const auto after =
        numbers_of(tightened_file(problem, k, tightening[static_cast<std::size_t>(k)]));
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] == before[i]) continue;
      Path path = path_of_task(text, k);
      path.insert(path.end(), after[i].first.begin(), after[i].first.end());
      text = with_key(text, path, fmt::format("{}", *after[i].second));
    }
  }
  try {
    (void)parse_task_tables(text, problem.set.file);
  } catch (const InputError&) {
    return "";
  }
  return text;
}

}  // namespace legwright
