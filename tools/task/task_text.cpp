// SPDX-License-Identifier: Apache-2.0
#include "tools/task/task_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include <toml++/toml.h>

#include "tools/task/text_place.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

constexpr const char* kRobotBeside = "robot.xml";

}  // namespace

std::size_t text_offset(const std::string& text, const toml::source_position& position) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (toml::source_index line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
  const auto continues = [&] {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  for (toml::source_index column = 1; column < position.column; ++column)
    for (++at; continues();) ++at;
  return std::min(at, text.size());
}

std::string with_value_at(const std::string& text, const toml::node& value, const std::string& by) {
  const std::size_t begin = text_offset(text, value.source().begin);
  const std::size_t end = text_offset(text, value.source().end);
  return text.substr(0, begin) + by + text.substr(end);
}

std::string text_beside_robot(const std::string& text) {
  const toml::table root = parse_toml(text, "task");
  const toml::node* robot = root.get("robot");
  if (robot == nullptr || robot->value<std::string>() == kRobotBeside) return text;
  return with_value_at(text, *robot, fmt::format("\"{}\"", kRobotBeside));
}

std::vector<std::string> path_of_task(const std::string& text, int task) {
  if (!parse_toml(text, "task").contains("task")) return {};
  return {"task", std::to_string(task)};
}

std::string with_weights(const std::string& text, const std::vector<double>& weights) {
  std::string out = text;
  for (std::size_t k = 0; k < weights.size(); ++k) {  // each moves what comes after it
    const toml::table root = parse_toml(out, "task");
    const toml::array* tasks = root["task"].as_array();
    if (tasks == nullptr || k >= tasks->size()) break;
    const toml::table& task = *tasks->get(k)->as_table();
    const toml::node *weight = task.get("weight"), *name = task.get("name");
    if (weight != nullptr && weight->value<double>() == weights[k]) continue;
    const std::string number = fmt::format("{}", weights[k]);
    if (weight != nullptr) {
      out = with_value_at(out, *weight, number);
    } else if (name != nullptr) {
      out.insert(text_offset(out, name->source().end), "\nweight = " + number);
    }
  }
  return out;
}

}  // namespace legwright
