// SPDX-License-Identifier: Apache-2.0
#include "tools/io/task_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>

#include "mjcf/input_error.hpp"
#include "tools/io/atomic_file.hpp"
#include "tools/io/io_error.hpp"
#include "tools/io/toml_reader.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;
constexpr const char* kRobotBeside = "robot.xml";
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::Vector2d vector2(const std::vector<double>& values) { return {values[0], values[1]}; }

void read_gait(TableReader in, TaskFile& task) {
  constexpr Range phase{0.0, 1.0, false, true, ""};
  task.gait = in.text("name").value_or("");
  const auto period = in.number("period", {0.05, 20.0, false, false, "s"});
  in.require(period.has_value(), "period", "period = 1.0  # s");
  task.period = period.value_or(1.0);
  task.knots = in.integer("knots", 8, 384).value_or(task.knots);
  task.duty = in.number("duty", {0.0, 1.0, true, false, ""});
  const toml::node* touchdown = in.node("touchdown");
  if (touchdown && touchdown->is_table())
    task.touchdown_by_foot = in.numbers_by_name("touchdown", phase);
  else
    task.touchdown = in.numbers("touchdown", phase, 0).value_or(std::vector<double>{});
  if (touchdown)
    in.require(in.has("duty"), "duty", "duty = 0.75  # share of the cycle on the ground");
  else
    in.require(in.has("name"), "name", "name = \"walk\"");
  if (task.gait.empty()) task.gait = "own";
  in.finish();
}

void read_travel(TableReader in, TaskFile& task) {
  const auto velocity = in.numbers("velocity", {-10.0, 10.0, false, false, "m/s"}, 2);
  in.require(velocity.has_value(), "velocity", "velocity = [0.0, 0.1]  # m/s forward, left");
  if (velocity) task.velocity = vector2(*velocity);
  task.turn_rate = in.number("turn_rate", {-10.0, 10.0, false, false, "rad/s"}).value_or(0.0);
  in.finish();
}

void read_style(TableReader in, TaskFile& task) {
  constexpr Range reach{-5.0, 5.0, false, false, "m"};
  task.com_height = in.number("com_height", {0.0, 5.0, true, false, "m"});
  const toml::node* footprint = in.node("footprint");
  const bool rows = footprint && footprint->is_array() && !footprint->as_array()->empty() &&
                    footprint->as_array()->get(0)->is_array();
  if (rows) {
    if (const auto pairs = in.pairs("footprint", reach))
      for (const auto& pair : *pairs) task.footprint.push_back(vector2(pair));
  } else if (const auto half = in.numbers("footprint", {0.0, 5.0, false, false, "m"}, 2)) {
    task.footprint = {vector2(*half)};
  }
  in.finish();
}

/// [["one limb", "another"], …]; names are looked up when the robot is known.
void read_limb_pairs(TableReader& in, Task& margins, Problems& problems) {
  const toml::node* found = in.node("limb_pairs");
  if (!found) return;
  std::vector<std::pair<std::string, std::string>> pairs;
  const toml::array* rows = found->as_array();
  for (std::size_t k = 0; rows && k < rows->size(); ++k) {
    const toml::array* row = rows->get(k)->as_array();
    if (!row || row->size() != 2) break;
    const auto first = row->get(0)->value_exact<std::string>();
    const auto second = row->get(1)->value_exact<std::string>();
    if (!first || !second) break;
    pairs.emplace_back(*first, *second);
  }
  if (!rows || pairs.size() != rows->size())
    problems.add(in.line_of("limb_pairs"), in.full("limb_pairs"),
                 "expected pairs of names of links or feet, for instance limb_pairs = "
                 "[[\"FL_foot\", \"HL_thigh\"]]; [] for no pair at all");
  else
    margins.limb_pairs = std::move(pairs);
}

void read_limits(TableReader in, TaskFile& task, Problems& problems) {
  Task& margins = task.margins;
  constexpr Range friction{0.0, 5.0, true, false, ""};
  margins.floor_friction = in.number("floor_friction", friction).value_or(margins.floor_friction);
  margins.friction = in.number("friction", friction).value_or(margins.friction);
  margins.swing_height =
      in.number("swing_height", {0.0, 1.0, false, false, "m"}).value_or(margins.swing_height);
  margins.min_normal =
      in.number("min_normal", {0.0, 0.5, false, false, ""}).value_or(margins.min_normal);
  margins.joint_margin =
      in.number("joint_margin", {0.0, 1.5, false, false, "rad"}).value_or(margins.joint_margin);
  margins.torque_margin =
      in.number("torque_margin", {0.0, 1.0, false, true, ""}).value_or(margins.torque_margin);
  margins.clearance =
      in.number("clearance", {0.0, 1.0, true, false, "m"}).value_or(margins.clearance);
  read_limb_pairs(in, margins, problems);
  task.planted_margin = in.number("planted_margin", {0.0, 1.0, false, false, "s"});
  if (margins.friction > margins.floor_friction)
    problems.add(
        in.line_of("friction"), in.full("friction"),
        fmt::format(
            "the plan would use more friction, {}, than the floor has, {}; plan with about half of "
            "limits.floor_friction",
            margins.friction, margins.floor_friction));
  in.finish();
}

std::filesystem::path find_robot(const std::string& name, const std::filesystem::path& task,
                                 int line) {
  const std::filesystem::path path = (task.parent_path() / name).lexically_normal();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError(
        task.string(), line, "robot",
        fmt::format("no such file: {}; give the robot's MJCF, relative to the task file",
                    path.string()));
  return path;
}

/// Where a position of the TOML parser, which counts code points, is in the text [bytes].
std::size_t offset_of(const std::string& text, const toml::source_position& position) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (toml::source_index line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
  const auto continues = [&] {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  for (toml::source_index column = 1; column < position.column; ++column)
    for (++at; continues();) ++at;
  return std::min(at, text.size());
}

std::string message_of(const toml::parse_error& error) {
  std::string text(error.description());
  if (text.find("','") != std::string::npos)
    text += " (numbers have a decimal point: 0.4, not 0,4)";
  return text + "; mend the TOML there, or cut the file back to the last line that is whole";
}

}  // namespace

int TaskFile::line(const std::string& key) const {
  const auto found = lines.find(key);
  if (found != lines.end()) return found->second;
  const auto section =
      lines.find(key.substr(0, key.find('.')));  // the table's line, where the key is absent
  return section != lines.end() ? section->second : 0;
}

TaskFile parse_task_file(const std::string& text, const std::filesystem::path& file) {
  toml::table root;
  try {
    root = toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(file.string(), static_cast<int>(error.source().begin.line), "",
                     message_of(error));
  }
  TaskFile task;
  task.file = file;
  task.text = text;
  Problems problems(file.string());
  TableReader in(&root, "", problems, task.lines);
  const auto robot = in.text("robot");
  in.require(robot.has_value(), "robot", "robot = \"robot.xml\"");
  task.name = in.text("name").value_or(file.stem().string());
  if (task.name.find_first_of("/\\") != std::string::npos || task.name.front() == '.')
    problems.add(
        in.line_of("name"), "name",
        fmt::format("is '{}'; it names a folder, so use letters, digits, _ and -", task.name));
  const auto section = [&](std::string_view key) {
    return TableReader(in.table(key), std::string(key), problems, task.lines);
  };
  read_gait(section("gait"), task);
  read_travel(section("travel"), task);
  read_style(section("style"), task);
  read_limits(section("limits"), task, problems);
  task.weights = in.numbers_by_name("weights", {0.0, kInfinity, false, false, ""});
  in.finish();
  problems.throw_if_any();
  task.robot = find_robot(*robot, file, task.line("robot"));
  return task;
}

std::string text_beside_robot(const TaskFile& file) {
  const toml::table root = toml::parse(file.text);
  const toml::node* robot = root.get("robot");
  if (robot == nullptr || robot->value<std::string>() == kRobotBeside) return file.text;
  const std::size_t begin = offset_of(file.text, robot->source().begin);
  const std::size_t end = offset_of(file.text, robot->source().end);
  return file.text.substr(0, begin) + '"' + kRobotBeside + '"' + file.text.substr(end);
}

TaskFile read_task_file(const std::filesystem::path& file) {
  std::string text;
  try {
    text = read_file(file, kMostBytes);
  } catch (const std::system_error& error) {
    throw InputError(
        file.string(), 0, "",
        error.code().message() + "; give the path of a task file, for instance sideways.toml");
  } catch (const IoError&) {
    throw InputError(file.string(), 0, "", "larger than 1 MiB; this is no task file");
  }
  return parse_task_file(text, file);
}

}  // namespace legwright
