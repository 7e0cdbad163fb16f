// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "tools/adopt/studied_robot.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_values.hpp"
#include "tools/files/parse_json.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/studio/proposal_view.hpp"
#include "tools/studio/session_names.hpp"
#include "tools/studio/start_page.hpp"
#include "tools/studio/state_json.hpp"
#include "tools/studio/studio_service.hpp"
#include "tools/studio/task_changes.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

Json error_json(const std::string& message, const std::string& where = {}, int line = 0) {
  return {{"error", {{"where", where}, {"message", message}, {"line", line}}}};
}

/// What the program would print, with the file of a line by its name alone; a session has none.
std::string told(const InputError& error) {
  std::string out;
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view kSession = "<session>: ";
    if (line.starts_with(kSession)) line.erase(0, kSession.size());
    const std::size_t end = line.find(": ");  // behind FILE:LINE
    const std::size_t name =
        end == std::string::npos ? end : line.find_last_not_of("0123456789", end - 1);
    if (line.starts_with('/') && name < end - 1 && line[name] == ':')
      line.erase(0, line.rfind('/', name) + 1);
    out += (out.empty() ? "" : "\n") + line;
  }
  return out;
}

/// Where a designer says that a robot faces; nothing where that is left to the robot.
Forward forward_of(const std::string& text) {
  Forward forward = facing_axis(text);
  if (!text.empty() && !forward)
    throw InputError("'forward' is " + text + ", expected +x, -x, +y or -y");
  return forward;
}

std::string query_of(const StudioRequest& request, const std::string& key) {
  const auto found = request.query.find(key);
  return found == request.query.end() ? "" : found->second;
}

/// The number of a task in ?task=, 0 without.
int task_of(const StudioRequest& request) {
  int number = 0;
  for (const char c : query_of(request, "task")) {
    if (c < '0' || c > '9' || number > 999) throw InputError("'task' is no number of a task");
    number = 10 * number + (c - '0');
  }
  return number;
}

Eigen::Vector3d vector_of(const Json& push, const char* key) {
  const auto numbers = given_or(push, key, std::vector<double>{0.0, 0.0, 0.0});
  if (numbers.size() != 3) throw InputError(fmt::format("'{}': expected three numbers", key));
  return {numbers[0], numbers[1], numbers[2]};
}

double within(const Json& body, const char* key, double otherwise, double low, double high) {
  const auto value = given_or(body, key, otherwise);
  if (!(value >= low && value <= high))
    throw InputError(fmt::format("'{}' is {}; expected {} to {}", key, value, low, high));
  return value;
}

/// A slope along the way, or along and across it [rad].
std::optional<std::array<double, 2>> slope_of_body(const Json& body) {
  if (!body.contains("slope") || body["slope"].is_null()) return std::nullopt;
  const Json& slope = body["slope"];
  if (slope.is_number()) return std::array{slope.get<double>(), 0.0};
  return needed<std::array<double, 2>>(body, "slope");
}

/// A key that undoes is pressed where there is nothing of it, too: then nothing happens.
void go_back(Session& session, const SessionCommand& which, const std::string& kind) {
  try {
    session.apply(which);
  } catch (const InputError& error) {
    if (error.where() != kind) throw;
  }
}

}  // namespace

const std::map<std::string, StudioService::Answer>& StudioService::answers() {
  static const std::map<std::string, Answer> table{
      {"GET /api/start", &StudioService::get_start},
      {"GET /api/free", &StudioService::get_free},
      {"GET /api/document", &StudioService::get_document},
      {"GET /api/design", &StudioService::get_design},
      {"GET /api/bounds", &StudioService::get_bounds},
      {"GET /api/motion", &StudioService::get_motion},
      {"GET /api/compare", &StudioService::get_compare},
      {"POST /api/open", &StudioService::post_open},
      {"POST /api/command", &StudioService::post_command},
      {"POST /api/tasks", &StudioService::post_tasks},
      {"GET /api/shown", &StudioService::get_shown},
      {"GET /api/example", &StudioService::get_example},
      {"GET /api/proposal", &StudioService::get_proposal},
      {"POST /api/proposal", &StudioService::post_proposal},
      {"POST /api/task", &StudioService::post_task},
      {"POST /api/physics", &StudioService::post_physics},
      {"POST /api/judge", &StudioService::post_judge},
      {"DELETE /api/judge", &StudioService::delete_judge},
      {"DELETE /api/job", &StudioService::delete_job},
      {"POST /api/optimize", &StudioService::post_optimize},
      {"POST /api/report", &StudioService::post_report},
      {"POST /api/export", &StudioService::post_export},
      {"POST /api/save", &StudioService::post_save},
      {"GET /api/modules", &StudioService::get_modules},
      {"GET /api/module", &StudioService::get_module},
      {"POST /api/assembly", &StudioService::post_assembly},
      {"POST /api/assembly/save", &StudioService::post_assembly_save},
      {"POST /api/assembly/build", &StudioService::post_build},
      {"POST /api/assembly/bench", &StudioService::post_bench},
  };
  return table;
}

StudioReply StudioService::answer(const StudioRequest& request) {
  try {
    const auto found = answers().find(request.method + " " + request.path);
    if (found == answers().end())
      return {404, to_line(error_json(request.method + " " + request.path +
                                      ": the studio knows no such request"))};
    return {200, to_line((this->*found->second)(request))};
  } catch (const InputError& error) {
    return {400, to_line(error_json(told(error), error.where(), error.line()))};
  } catch (const IoError& error) {
    return {409, to_line(error_json(error.what()))};
  } catch (const std::system_error& error) {
    return {409, to_line(error_json(error.what()))};
  } catch (const SessionClosed&) {
    return {409, to_line(error_json("another page has opened something else, so this was not done; "
                                    "look at what is open now"))};
  } catch (const std::exception& error) {
    return {500, to_line(error_json(std::string("internal error: ") + error.what()))};
  }
}

Json StudioService::get_start(const StudioRequest&) {
  return start_json(options_.examples, kept_, paths_.writable());
}

/// The path ?path=, where nothing is there yet; else one that is free and begins with it.
Json StudioService::get_free(const StudioRequest& request) {
  std::filesystem::path asked = query_of(request, "path");
  if (!asked.has_filename()) asked = asked.parent_path();  // "runs/mine/"
  if (asked.empty()) throw InputError("'path' is missing: a folder or file to be written");
  const std::string stem = (asked.parent_path() / asked.stem()).string();
  std::string path = asked.string();
  for (int k = 2; std::filesystem::exists(paths_.to_write(path)); ++k)
    path = fmt::format("{}_{}{}", stem, k, asked.extension().string());
  return {{"path", path}};
}

Json StudioService::get_document(const StudioRequest&) {
  Json out = workspace()->document();
  const std::lock_guard lock(mutex_);
  out["path"] = opened_.origin.string();
  out["label"] = opened_.label;
  return out;
}

/// Of the present, of a snapshot, or of other values: ?snapshot=NAME, ?values={"NAME": 0.1}.
Json StudioService::get_design(const StudioRequest& request) {
  const auto space = workspace();
  const StatePointer state = space->find(query_of(request, "snapshot"));
  const std::string values = query_of(request, "values");
  if (values.empty()) return space->design(*state);
  const Json other = parse_json(values);
  if (!other.is_object()) throw InputError("'values' is no JSON object of names and numbers");
  Eigen::VectorXd s = state->s();
  for (const auto& [name, value] : other.items()) {
    const int i = space->robot().space.find(name);
    if (i < 0 || !value.is_number())
      throw InputError(fmt::format("'{}' is no design parameter, or its value no number", name));
    s[i] = value.get<double>();
  }
  return space->design_at(s);
}

/// The ghosts of a parameter: ?name=NAME&task=0.
Json StudioService::get_bounds(const StudioRequest& request) {
  return workspace()->at_bounds(query_of(request, "name"), task_of(request));
}

Json StudioService::get_motion(const StudioRequest& request) {
  const auto space = workspace();
  return space->motion(*space->find(query_of(request, "snapshot")), task_of(request));
}

/// A snapshot as it is drawn beside the present: its body and a motion.
Json StudioService::get_shown(const StudioRequest& request) {
  const auto space = workspace();
  const StatePointer state = space->find(query_of(request, "name"));
  return {{"design", space->design(*state)}, {"motion", space->motion(*state, task_of(request))}};
}

Json StudioService::get_compare(const StudioRequest& request) {
  const auto space = workspace();
  const auto a = space->find(query_of(request, "a")), b = space->find(query_of(request, "b"));
  Json found = comparison_json(*a, *b);
  found["verdict"] = {{"a", verdict_on(*a)}, {"b", verdict_on(*b)}};
  return found;
}

Json StudioService::get_example(const StudioRequest& request) {
  return example_picture(example_file(options_.examples, query_of(request, "name")), meshes_);
}

/// A path, an example by its name, or the files of a robot that was dropped.
Json StudioService::post_open(const StudioRequest& request) {
  const Json& body = request.body;
  if (body.is_object() && body.contains("files"))
    open(write_sent_files(kept_.new_robot_folder(), body["files"]).string());
  else if (body.is_object() && body.contains("example"))
    open(example_file(options_.examples, needed<std::string>(body, "example")).string());
  else if (given_or(body, "new_assembly", false))
    open_new_assembly();
  else
    open(needed<std::string>(body, "path"));
  return Json::object();
}

/// As it faces, or as ?forward=+y says.
Json StudioService::get_proposal(const StudioRequest& request) {
  return proposal_json(
      study_robot(proposing(), paths_.reach(), forward_of(query_of(request, "forward"))));
}

/// Declares what was ticked, in a file of its own where one is named, and opens the robot with the
/// first task by its size.
Json StudioService::post_proposal(const StudioRequest& request) {
  const std::lock_guard opening_lock(opening_);
  const auto file = proposing();
  const Forward forward = forward_of(given_or<std::string>(request.body, "forward", ""));
  RobotModel robot = with_proposals(study_robot(file, paths_.reach(), forward),
                                    needed<std::vector<std::string>>(request.body, "parameters"));
  const auto path = given_or<std::string>(request.body, "path", "");
  if (!path.empty()) {
    const auto written = paths_.to_write(path);
    if (std::filesystem::exists(written))
      throw IoError(written.string() + ": exists already; name a new file");
    write_main_file(written, robot.files);
  }
  take(open_robot(std::move(robot), file, forward));
  return Json::object();
}

Json StudioService::post_task(const StudioRequest& request) {
  const auto space = workspace();
  const StatePointer state = space->session().snapshot()->state;
  const auto task = given_or(request.body, "task", 0);
  if (task < 0 || task >= state->problem->task_count())
    throw InputError(
        fmt::format("task {}: expected 0 to {}", task, state->problem->task_count() - 1));
  const std::string weighted = state->problem->set.joint()
                                   ? with_weights(state->problem->set.text, state->weights)
                                   : state->problem->set.text;
  space->session().apply(
      session::Tasks{with_changes(weighted, task, needed<Json>(request.body, "changes"))});
  return {{"revision", space->session().snapshot()->revision}};
}

Json StudioService::post_physics(const StudioRequest& request) {
  const auto space = workspace();
  const Json& body = request.body;
  PhysicsSettings settings = space->physics().settings();
  settings.run = given_or(body, "run", settings.run);
  settings.task = given_or(body, "task", settings.task);
  if (body.contains("gains")) {
    const auto gains = needed<std::array<double, 2>>(body, "gains");
    for (const double gain : gains)
      if (!(gain > 0.0 && gain <= 100.0))
        throw InputError(fmt::format("'gains': a factor is {}; expected more than 0 to 100", gain));
    settings.stiffness = gains[0];
    settings.damping = gains[1];
  }
  settings.speed = within(body, "speed", settings.speed, 0.01, 10.0);
  if (body.contains("friction")) settings.friction = within(body, "friction", 0.8, 0.0, 10.0);
  if (body.contains("slope")) settings.slope = slope_of_body(body);
  if (body.contains("push")) {
    settings.push = {};
    if (body["push"].is_object())
      settings.push = {needed<int>(body["push"], "body"), vector_of(body["push"], "force"),
                       vector_of(body["push"], "point")};
  }
  if (given_or(body, "reset", false)) ++settings.reset;
  space->physics().set(settings);
  return Json::object();
}

/// A command of the journal, or what a search is told: start, pause, step, work_out.
Json StudioService::post_command(const StudioRequest& request) {
  const auto space = workspace();
  Session& session = space->session();
  const auto kind = needed<std::string>(request.body, "do");
  if (kind == "start") {
    session.start();
  } else if (kind == "pause") {
    session.pause();
  } else if (kind == "step") {
    if (!session.step()) hub_.notice("info", "No better body is near.");
  } else if (kind == "work_out") {
    session.work_out(SessionEngine::kind_of(needed<std::string>(request.body, "what")));
  } else if (kind == "settled" || kind == "searched" || kind == "worked_out") {
    throw InputError("'" + kind + "' is for journals alone: what is solved is noted by itself");
  } else {
    Json command = request.body;
    if ((kind == "edit" || kind == "choose") && !command.contains("goes_on"))
      command["goes_on"] = false;
    if (kind == "freeze" && !command.contains("frozen")) command["frozen"] = true;
    const bool held = given_or(command, "held", false);
    command.erase("held");
    const SessionCommand read = command_of(command, "command", 0);
    if (kind == "undo" || kind == "redo")
      go_back(session, read, kind);
    else
      session.apply(read, held);
  }
  return {{"revision", session.snapshot()->revision}};
}

Json StudioService::post_tasks(const StudioRequest& request) {
  const auto space = workspace();
  space->session().apply(session::Tasks{needed<std::string>(request.body, "text")});
  return {{"revision", space->session().snapshot()->revision}};
}

Json StudioService::post_save(const StudioRequest& request) {
  const auto path = paths_.to_write(needed<std::string>(request.body, "path"));
  const bool force = given_or(request.body, "force", false);
  const WhatStands now = standing();
  save(now, path, force);
  {
    const std::lock_guard lock(mutex_);
    saved_ = now.record.state;
    saved_at_ = path;
  }
  kept_.note_recent(path, session_name(now.label, path));
  return {{"path", path.string()}};
}

}  // namespace legwright
