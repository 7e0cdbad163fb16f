// SPDX-License-Identifier: Apache-2.0
#include "tools/task/task_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "mjcf/text/input_error.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/motion/margins.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/task/design_table.hpp"
#include "tools/task/gait_table.hpp"
#include "tools/task/style_table.hpp"
#include "tools/task/task_table.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;
constexpr const char* kReference = "every key: docs/task_file.md, `legwright check --keys`";

Eigen::Vector2d vector2(const std::vector<double>& values) { return {values[0], values[1]}; }

void read_forward(TaskTable& in, TaskFile& task, Problems& problems) {
  const auto text = in.text("forward");
  if (!text) return;
  if (const auto axis = facing_axis(*text))
    task.forward = *axis;
  else
    problems.add(
        in.line_of("forward"), in.full("forward"),
        fmt::format("is '{}'; expected the axis of the trunk's frame along which the robot "
                    "looks: \"+x\", \"-x\", \"+y\" or \"-y\"",
                    *text));
}

void read_travel(TaskTable in, TaskFile& task, Problems& problems) {
  read_forward(in, task, problems);
  const auto velocity = in.numbers("velocity");
  in.require(velocity.has_value(), "velocity", "velocity = [0.0, 0.1]  # m/s forward, left");
  if (velocity) task.velocity = vector2(*velocity);
  task.turn_rate = in.number("turn_rate").value_or(0.0);
  task.aim_speed = in.number("aim_speed").value_or(1.0);
  task.aim_turn_rate = in.number("aim_turn_rate").value_or(0.0);
  in.finish();
}

/// [["one limb", "another"], …]; names are looked up when the robot is known.
void read_limb_pairs(TaskTable& in, Task& margins, Problems& problems) {
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

/// Without a height of its own the plan swings high enough (margins.hpp).
void read_swing(TaskTable& in, TaskFile& task, Problems& problems) {
  Task& margins = task.margins;
  if (const auto height = in.number("swing_height")) margins.swing_height = height;
  margins.step_over = in.number("step_over").value_or(margins.step_over);
  if (!margins.swing_height || *margins.swing_height >= margins.step_over) return;
  const char* key = in.has("swing_height") ? "swing_height" : "step_over";
  problems.add(
      in.line_of(key), in.full(key),
      fmt::format("steps over {} m are asked for (limits.step_over) with a swing height "
                  "of {} m; raise limits.swing_height, or leave it out for {:.3g} m",
                  margins.step_over, *margins.swing_height, kSwingOver * margins.step_over));
}

void read_limits(TaskTable in, TaskFile& task, Problems& problems) {
  Task& margins = task.margins;
  margins.floor_friction = in.number("floor_friction").value_or(margins.floor_friction);
  margins.friction = in.number("friction").value_or(margins.friction);
  read_swing(in, task, problems);
  if (const auto limit = in.number("torque_limit")) margins.torque_limit = limit;
  margins.min_normal = in.number("min_normal").value_or(margins.min_normal);
  margins.joint_margin = in.number("joint_margin").value_or(margins.joint_margin);
  margins.torque_margin = in.number("torque_margin").value_or(margins.torque_margin);
  if (const auto clearance = in.number("clearance")) margins.clearance = clearance;
  read_limb_pairs(in, margins, problems);
  if (const auto margin = in.number("planted_margin")) task.planted_margin = margin;
  if (margins.friction > margins.floor_friction)
    problems.add(
        in.line_of("friction"), in.full("friction"),
        fmt::format(
            "the plan would use more friction, {}, than the floor has, {}; plan with about half of "
            "limits.floor_friction",
            margins.friction, margins.floor_friction));
  in.finish();
}

/// The slope of the ground; up on it is known with the way to go.
void read_ground(TaskTable in, TaskFile& task) {
  task.slope_along = in.number("slope_along").value_or(task.slope_along);
  task.slope_across = in.number("slope_across").value_or(task.slope_across);
  in.finish();
}

void read_payload(TaskTable in, TaskFile& task) {
  const auto mass = in.number("mass");
  const auto position = in.numbers("position");
  const auto size = in.numbers("size");
  if (in.has("position") || in.has("size")) in.require(in.has("mass"), "mass", "mass = 0.5  # kg");
  in.finish();
  if (!mass) return;
  Payload payload{*mass, Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(water_cube(*mass))};
  if (position) payload.position = Eigen::Vector3d::Map(position->data());
  if (size) payload.size = Eigen::Vector3d::Map(size->data());
  task.margins.payload = payload;
}

/// How stiff servos are played that the robot's file has softer.
void read_servos(TaskTable in, TaskFile& task) {
  if (const auto kp = in.number("kp")) task.margins.servo_kp = kp;
  if (const auto kd = in.number("kd")) task.margins.servo_kd = kd;
  if (in.has("kd")) in.require(in.has("kp"), "kp", "kp = 300.0  # N m/rad");
  in.finish();
}

/// @param name as the task file or the command line has it, already from the working directory
std::filesystem::path given_robot(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) return path.lexically_normal();
  throw InputError(path.string(), 0, "", "no such file; give the MJCF of a robot after --robot");
}

std::filesystem::path find_robot(const std::string& name, const std::filesystem::path& task,
                                 int line) {
  std::filesystem::path path = (task.parent_path() / name).lexically_normal();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError(
        task.string(), line, "robot",
        fmt::format("no such file: {}; give the robot's MJCF, relative to the task file",
                    path.string()));
  return path;
}

/// A robot in the place of a task is told by what to do with it, not by where its TOML is wrong.
void refuse_robot(const std::string& text, const std::filesystem::path& file) {
  const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first == std::string::npos || text[first] != '<') return;
  const std::string output =
      is_urdf(text) ? fmt::format(" -o {}.xml", file.stem().string()) : std::string();
  throw InputError(
      file.string(), 0, "",
      fmt::format("found XML, as a robot has it; expected a task file (TOML), which names its "
                  "robot. `legwright init {}{} --task task.toml` writes a first one{}",
                  file.string(), output,
                  output.empty() ? "" : " and the robot as MJCF, which a task can name"));
}

void check_name(TaskTable& in, const std::string& name, Problems& problems) {
  if (name.find_first_of("/\\") == std::string::npos && !name.empty() && name.front() != '.')
    return;
  problems.add(in.line_of("name"), in.full("name"),
               fmt::format("is '{}'; it names a folder, so use letters, digits, _ and -", name));
}

/// Names of tasks become folders beside those of the starts: "from-NAME", "NAME-alone".
void check_task_name(TaskTable& in, const std::string& name, Problems& problems) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  const bool taken = name == "initial" || name.starts_with("random-") ||
                     name.starts_with("from-") || name.ends_with("-alone");
  if (plain && name.size() <= 60 && !taken) return;
  problems.add(in.line_of("name"), in.full("name"),
               fmt::format("is '{}'; it names a folder, so use up to 60 letters, digits, _ and -, "
                           "and not initial, random-…, from-… or …-alone, which name starts",
                           name));
}

void read_outer(TaskTable in, TaskSet& set) {
  set.outer = in.text("objective").value_or("");
  if (in.has("weight"))
    in.require(in.has("objective"), "objective", "objective = \"mechanical_work\"");
  set.outer_weight = in.number("weight").value_or(1.0);
  in.finish();
}

/// Which model eq (13) has of the robot that turns.
void read_dynamics(TaskTable& in, TaskFile& task, Problems& problems) {
  const auto name = in.text("dynamics");
  if (!name) return;
  if (*name == "full")
    task.margins.dynamics = Dynamics::full;
  else if (*name == "constant_inertia")
    task.margins.dynamics = Dynamics::constant_inertia;
  else
    problems.add(in.line_of("dynamics"), in.full("dynamics"),
                 fmt::format("is '{}'; expected \"full\", the angular momentum of all bodies as "
                             "they move, or \"constant_inertia\", the paper's equation (13)",
                             *name));
}

/// What may stand outside [[task]] and then holds for all.
void read_shared_tables(TaskTable& in, TaskFile& task, Problems& problems) {
  const auto section = [&](std::string_view key) {
    return TaskTable(in.table(key), in.full(key), problems, task.lines);
  };
  read_dynamics(in, task, problems);
  read_style(section("style"), task);
  read_limits(section("limits"), task, problems);
  read_ground(section("ground"), task);
  read_payload(section("payload"), task);
  read_servos(section("servos"), task);
  for (const auto& [name, weight] : in.numbers_by_name("weights")) task.weights[name] = weight;
}

void read_task_tables(TaskTable& in, TaskFile& task, Problems& problems) {
  const auto section = [&](std::string_view key) {
    return TaskTable(in.table(key), in.full(key), problems, task.lines);
  };
  read_gait(section("gait"), task);
  read_travel(section("travel"), task, problems);
  read_shared_tables(in, task, problems);
}

void read_tasks(const std::vector<const toml::table*>& tables, const TaskFile& shared, TaskSet& set,
                Problems& problems) {
  for (const toml::table* table : tables) {
    TaskFile task = shared;
    TaskTable in(table, "", problems, task.lines);
    const auto name = in.text("name");
    in.require(name.has_value(), "name", "name = \"pace\"");
    task.name = name.value_or("");
    if (name) check_task_name(in, task.name, problems);
    const bool taken = std::any_of(set.tasks.begin(), set.tasks.end(),
                                   [&](const TaskFile& other) { return other.name == task.name; });
    if (name && taken)
      problems.add(in.line_of("name"), "name",
                   fmt::format("another task is named '{}' too; each has a folder of its own, so "
                               "give different names",
                               task.name));
    task.weight = in.number("weight").value_or(1.0 / static_cast<double>(tables.size()));
    read_task_tables(in, task, problems);
    in.finish();
    set.tasks.push_back(std::move(task));
  }
}

}  // namespace

TaskSet parse_task_tables(const std::string& text, const std::filesystem::path& file) {
  refuse_robot(text, file);
  const toml::table root = parse_toml(text, file);
  TaskSet set;
  set.file = file;
  set.text = text;
  Problems problems(file.string(), kReference);
  TaskTable in(&root, "", problems, set.lines);
  const auto robot = in.text("robot");
  in.require(robot.has_value(), "robot", "robot = \"robot.xml\"");
  set.name = in.text("name").value_or(file.stem().string());
  check_name(in, set.name, problems);
  const auto tables = in.tables("task");
  read_outer(TaskTable(in.table("outer"), "outer", problems, set.lines), set);
  set.design =
      read_design_table(TaskTable(in.table("design"), "design", problems, set.lines), problems);
  TaskFile shared;  // what stands outside [[task]]
  shared.file = file;
  shared.text = text;
  shared.name = set.name;
  if (tables.empty()) {
    read_task_tables(in, shared, problems);
    in.finish();
    set.tasks = {shared};
  } else {
    read_shared_tables(in, shared, problems);
    in.finish();
    read_tasks(tables, shared, set, problems);
  }
  problems.throw_if_any();
  set.robot = *robot;
  for (TaskFile& task : set.tasks) {
    task.robot = set.robot;
    task.lines.insert(set.lines.begin(), set.lines.end());  // of what holds for all
  }
  return set;
}

TaskSet parse_task_set(const std::string& text, const std::filesystem::path& file,
                       const std::filesystem::path& other_robot) {
  TaskSet set = parse_task_tables(text, file);
  set.robot = other_robot.empty() ? find_robot(set.robot.string(), file, set.line("robot"))
                                  : given_robot(other_robot);
  for (TaskFile& task : set.tasks) task.robot = set.robot;
  return set;
}

TaskFile parse_task_file(const std::string& text, const std::filesystem::path& file) {
  TaskSet set = parse_task_set(text, file);
  if (set.joint())
    throw InputError(file.string(), set.line("task"), "task",
                     "one task was expected here; the file holds several");
  return std::move(set.tasks.front());
}

namespace {

std::string text_of(const std::filesystem::path& file) {
  try {
    return read_file(file, kMostBytes);
  } catch (const std::system_error& error) {
    throw InputError(
        file.string(), 0, "",
        error.code().message() + "; give the path of a task file, for instance sideways.toml");
  } catch (const IoError&) {
    throw InputError(file.string(), 0, "",
                     std::filesystem::is_regular_file(file)
                         ? "larger than 1 MiB; this is no task file"
                         : "is a pipe, a socket or a device; expected a regular file");
  }
}

}  // namespace

TaskSet read_task_set(const std::filesystem::path& file, const std::filesystem::path& robot) {
  return parse_task_set(text_of(file), file, robot);
}

TaskFile read_task_file(const std::filesystem::path& file) {
  return parse_task_file(text_of(file), file);
}

}  // namespace legwright
