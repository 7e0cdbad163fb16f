// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/opening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "tools/adopt/studied_robot.hpp"
#include "tools/files/io_error.hpp"
#include "tools/modules/assembly_file.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/robot_label.hpp"
#include "tools/run/run_record.hpp"
#include "tools/session/journal.hpp"
#include "tools/studio/kept_sessions.hpp"
#include "tools/task/problem.hpp"
#include "tools/task/starter_task.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

Opening open_assembly(const fs::path& file) {
  Opening out;
  out.origin = out.file = file;
  out.assembly = read_file(file);
  return out;
}

/// A task file, or an assembly.
Opening open_toml(const fs::path& file, const AllowedPaths& paths) {
  if (is_assembly(read_file(file), file)) return open_assembly(file);
  const TaskSet set = read_task_set(file);
  Opening out;
  out.origin = out.file = file;
  out.text = set.text;
  out.robot = read_robot(paths.to_read(set.robot.string()), paths.reach());
  return out;
}

/// The robot of a file where that is one to be designed as it stands; nothing where it declares no
/// parameters, or has to be made ready. Throws InputError where that cannot be done either.
std::optional<RobotModel> ready_robot(const fs::path& file, const FileReach& reach) {
  if (!is_urdf(read_file(file))) {
    try {
      RobotModel robot = read_robot(file, reach);
      if (robot.space.size() > 0) return robot;
      return std::nullopt;
    } catch (const InputError&) {  // study_robot() knows better, or says more of why
    }
  }
  (void)study_robot(file, reach);
  return std::nullopt;
}

Opening open_robot_file(const fs::path& file, const FileReach& reach) {
  if (std::optional<RobotModel> robot = ready_robot(file, reach))
    return open_robot(*std::move(robot), file);
  Opening out;
  out.origin = file;
  out.proposes = true;
  return out;
}

/// What a journal of this robot says. Throws InputError where it is another robot.
Opening open_journal(const fs::path& journal, const fs::path& robot_file, const FileReach& reach) {
  ReadJournal read = read_journal(journal);
  Opening out;
  out.robot = read_robot(robot_file, reach);
  const SessionBegin now = begin_of(*out.robot, read.begin.text, read.begin.file);
  if (now.robot_sha256 != read.begin.robot_sha256)
    throw InputError(journal.string(), 1, "robot",
                     robot_file.string() +
                         " is another one, or has been changed, since this "
                         "journal began; put back the one that it was");
  out.text = std::move(read.begin.text);
  out.file = std::move(read.begin.file);
  out.commands = std::move(read.commands);
  return out;
}

/// The edits that lead from the given body to a run's result.
std::vector<SessionCommand> edits_to(const RunRecord& run, const DesignTable& design) {
  session::Edit edit;
  for (const ParameterRecord& one : run.parameters) {
    const auto told = design.given.find(one.name);
    const double given = told == design.given.end() ? one.initial : told->second;
    if (one.final != given && one.lower < one.upper)
      edit.values[one.name] = std::clamp(one.final, one.lower, one.upper);
  }
  if (edit.values.empty()) return {};
  return {edit};
}

/// The task by which a tightened gait is planned, or a note that there is none: in runs of earlier
/// programs, or of a design that the run does not keep. What is planned without it is not judged.
void take_over_tightened(const ResultFolder& run, const RunRecord& record, Opening& out) {
  const std::string& name = record.result_name();
  const fs::path candidate = path_below(record.result_candidate()),
                 task = run.root() / candidate / kTightenedTask;
  if (!candidate.empty() && fs::is_regular_file(task)) {
    out.file = task;
    out.note = fmt::format(
        "This gait is planned more strictly than the run's task says ({}), for MuJoCo failed the "
        "plan by that task alone. The task here is the stricter one: {} is its text.",
        name, task.string());
    return;
  }
  out.judged.clear();
  out.note = fmt::format(
      "The gait that this run hands back is planned more strictly than its task says ({}). The "
      "Studio plans the gait of its body anew, as the task says, and MuJoCo may fail that one; "
      "the run's own gait comes out of: legwright export {}",
      name, run.root().string());
}

Opening open_run_folder(const fs::path& folder, const FileReach& reach) {
  const ResultFolder run = ResultFolder::open(folder);
  const auto record = read_record_file<RunRecord>(run.run_json());
  const fs::path robot = run.inputs() / "robot.xml", journal = run.inputs() / "session.jsonl";
  Opening out;
  if (fs::is_regular_file(journal)) {
    out = open_journal(journal, robot, reach);
    out.judged = folder;
  } else {
    out.file = run.inputs() / "task.toml";
    const bool stepped = record.physics_steps && record.physics_steps->changed;
    if (!stepped) out.judged = folder;
    if (record.tightened() && !stepped) take_over_tightened(run, record, out);
    out.text = read_file(out.file);
    out.robot = read_robot(robot, reach);
    out.commands = edits_to(record, parse_task_tables(out.text, out.file).design);
  }
  out.origin = folder;
  if (const std::string* file = record.files.find("robot.xml")) {
    out.robot_file = *file;
    out.robot->morphology.name = robot_label(record.robot, *file, *file);
  }
  return out;
}

}  // namespace

DesignSpace check_fit(const Opening& opening) {
  TaskSet set = parse_task_tables(opening.text, opening.file);
  set.robot = opening.robot->file;
  return make_problem(std::move(set), *opening.robot).robot.space;
}

Opening open_robot(RobotModel robot, const fs::path& origin, const Forward& ahead) {
  const std::string missing = no_task_text(robot);
  if (!missing.empty()) throw InputError(origin.string(), 0, "", missing);
  Opening out;
  out.origin = origin;
  StarterTask task = starter_task(robot, std::nullopt);
  if (ahead) task.ahead = *ahead;
  out.text = starter_text(task, origin.filename().string());
  out.file = origin.parent_path() / "first.toml";
  out.robot = std::move(robot);
  return out;
}

Opening open_path(const fs::path& path, const AllowedPaths& paths) {
  if (fs::is_directory(path)) {
    if (fs::is_regular_file(path / "run.json")) return open_run_folder(path, paths.reach());
    if (const auto kept = kept_session(path)) {
      const fs::path journal = path / "session.jsonl";
      Opening out = fs::is_regular_file(journal)
                        ? open_journal(journal, path / "robot" / "robot.xml", paths.reach())
                        : open_assembly(path / kKeptAssembly);
      out.origin = kept->origin.empty() ? path : fs::path(kept->origin);
      out.taken_up = path;
      return out;
    }
    throw InputError(
        path.string() +
        ": is no run and no session; open a robot's MJCF, a task file, an assembly, or "
        "the folder of a run");
  }
  if (!fs::is_regular_file(path)) throw IoError(path.string() + ": no such file");
  return path.extension() == ".toml" ? open_toml(path, paths)
                                     : open_robot_file(path, paths.reach());
}

}  // namespace legwright
