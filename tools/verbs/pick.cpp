// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/inertia.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/replace_folder.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/files/unfinished_path.hpp"
#include "tools/run/by_name.hpp"
#include "tools/run/iteration_record.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/run/run_json.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/verbs/feasibility.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct PickOptions : ReadingOptions {
  std::string run, start, candidate;
  int iteration = -1, front = -1;
};

/// What was asked for is not in the run.
[[noreturn]] void refuse_pick(const fs::path& run, const std::string& why) {
  throw InputError(fmt::format("{}: {}", run.string(), why));
}

/// A design of a run: its words, and the folder of each task's files.
struct PickedDesign {
  std::string name;
  std::vector<fs::path> folders;  // in the order of the run's tasks
};

std::vector<std::string> task_names(const RunRecord& run) {
  std::vector<std::string> names;
  if (run.joint())
    for (const TaskRecord& task : *run.tasks) names.push_back(task.name);
  return names;
}

/// The same folder of each task: under `joint`/TASK of a run of several, else `single`.
std::vector<fs::path> folders_of(const RunRecord& run, const fs::path& single) {
  if (!run.joint()) return {single};
  std::vector<fs::path> out;
  for (const std::string& task : task_names(run)) out.push_back(single / task);
  return out;
}

PickedDesign picked_iteration(const ResultFolder& folder, const RunRecord& run, int index) {
  PickedDesign out{fmt::format("iteration {}", index), {}};
  const std::string number = fmt::format("{:04}", index);
  if (!run.joint()) out.folders = {folder.iteration(index)};
  for (const std::string& task : task_names(run))
    out.folders.push_back(folder.root() / "tasks" / task / "iterations" / number);
  return out;
}

/// The last iteration of a start.
PickedDesign picked_start(const ResultFolder& folder, const RunRecord& run,
                          const std::string& name) {
  const std::vector<StartRecord> starts = run.starts.value_or(std::vector<StartRecord>{});
  const auto found = std::find_if(starts.begin(), starts.end(),
                                  [&](const StartRecord& start) { return start.start == name; });
  if (found == starts.end()) {
    std::vector<std::string> known;
    known.reserve(starts.size());
    for (const StartRecord& start : starts) known.push_back(start.start);
    refuse_pick(folder.root(),
                known.empty()
                    ? fmt::format("has no start '{}': it searched from one design only; pick one "
                                  "of its iterations with --iteration N",
                                  name)
                    : fmt::format("has no start '{}'; there are {}", name, fmt::join(known, ", ")));
  }
  PickedDesign out{"start " + name, {}};
  if (!run.joint()) {  // iterations of all starts follow one another
    int last = -1;
    for (auto start = starts.begin(); start <= found; ++start) last += start->design_iterations + 1;
    out.folders = {folder.iteration(last)};
  }
  for (const std::string& task : task_names(run))
    out.folders.push_back(folder.root() / "starts" / ("from-" + name) / task / "iterations" /
                          fmt::format("{:04}", found->design_iterations));
  return out;
}

PickedDesign picked_front_point(const ResultFolder& folder, const RunRecord& run, int point) {
  if (!run.front)
    refuse_pick(folder.root(), "has no front; `legwright optimize --front N` makes one");
  if (point >= static_cast<int>(run.front->size()))
    refuse_pick(folder.root(),
                fmt::format("has no point {} of the front: they are numbered 0 to {}", point,
                            run.front->size() - 1));
  return {fmt::format("front point {}", point),
          folders_of(run, folder.root() / "front" / fmt::format("{:02}", point))};
}

PickedDesign picked_candidate(const ResultFolder& folder, const RunRecord& run,
                              const std::string& name) {
  std::vector<std::string> known;
  if (run.choice)
    for (const CandidateRecord& candidate : run.choice->candidates) {
      if (!candidate.folder) continue;
      if (candidate.name == name) return {name, folders_of(run, folder.root() / *candidate.folder)};
      known.push_back("'" + candidate.name + "'");
    }
  refuse_pick(folder.root(), known.empty() ? "keeps no candidates beside its result"
                                           : fmt::format("has no candidate '{}'; it keeps {}", name,
                                                         fmt::join(known, ", ")));
}

PickedDesign find_design(const ResultFolder& folder, const RunRecord& run,
                         const PickOptions& options) {
  if (!options.candidate.empty()) return picked_candidate(folder, run, options.candidate);
  if (!options.start.empty()) return picked_start(folder, run, options.start);
  if (options.front >= 0) return picked_front_point(folder, run, options.front);
  return picked_iteration(folder, run, options.iteration);
}

/// Puts a design in place of a task's result. @return what its metrics.json says
IterationMetrics replace_result(const fs::path& from, const fs::path& result,
                                const RobotFiles& files) {
  auto metrics = read_record_file<IterationMetrics>(from / "metrics.json");
  const fs::path fresh = result.parent_path() / ".result-picked";
  fs::remove_all(fresh);  // of a run that was killed
  try {
    copy_design(from, fresh, files);
    replace_folder(fresh, result);
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove_all(fresh, ignored);
    throw;
  }
  return metrics;
}

double value_of(const ByName<double>& s, const std::string& parameter) {
  const double* const value = s.find(parameter);
  if (value == nullptr)
    throw IoError(fmt::format("metrics.json of the design lacks parameter '{}' of s", parameter));
  return *value;
}

std::string speed_unit_of(const TaskRecord& task) {
  return task.velocity[0] == 0.0 && task.velocity[1] == 0.0 ? "rad/s" : "m/s";
}

/// Why the picked plan does not do its task, and what MuJoCo said of it if it was played.
std::vector<std::string> reasons_of(const RunRecord& run, const std::string& name,
                                    const IterationMetrics& metrics, const TaskRecord& task) {
  PlanQuality quality;
  quality.speed_reached = metrics.speed_reached;
  quality.speed_wanted = metrics.speed_wanted;
  quality.heading_error = metrics.heading_error;
  quality.ground_error = metrics.ground_error;
  quality.slide_share = metrics.slide_share;
  quality.root_residual = metrics.root_residual;
  std::vector<std::string> reasons = infeasible_reasons(true, quality, speed_unit_of(task));
  if (!run.choice) return reasons;
  if (auto words = run.choice->complaint(name, task.name)) reasons.push_back(std::move(*words));
  return reasons;
}

/// What run.json says of the design in result/. What was said of the old one goes away.
void note_design(RunRecord& run, const RobotModel& robot, const std::string& name,
                 const IterationMetrics& metrics) {
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    s[k] = value_of(metrics.s, run.parameters.at(i).name);
    run.parameters[i].final = s[k];
  }
  run.body->final = body_record(robot, s);
  run.picked = name;
  run.certificate.reset();
  run.physics_steps.reset();
  run.put_back.reset();
  run.fewest_changes.reset();
  run.final_F = metrics.F;
}

/// The same of a run of one task, or of a task of several.
void note_task_design(RunRecord& run, const RobotModel& robot, const std::string& name,
                      const IterationMetrics& metrics) {
  note_design(run, robot, name, metrics);
  run.final_terms = metrics.terms;
  run.reasons = reasons_of(run, name, metrics, *run.task);
  run.feasible = run.reasons->empty();
  run.speed_reached = metrics.speed_reached;
  run.heading_error = metrics.heading_error;
  run.ground_error = metrics.ground_error;
  run.slide_share = metrics.slide_share;
  run.root_residual = metrics.root_residual;
  run.motion_status = metrics.motion_status;
  run.projected_gradient_norm = metrics.projected_gradient_norm;
}

/// The same of each task of a joint run, and of the body that they share.
void pick_joint(const ResultFolder& folder, const PickedDesign& picked, const RobotModel& robot,
                RunRecord& run) {
  double F = 0.0;
  std::vector<std::string> reasons;
  for (std::size_t k = 0; k < run.tasks->size(); ++k) {
    TaskRecord& task = run.tasks->at(k);
    const fs::path own = folder.root() / "tasks" / task.name;
    const IterationMetrics metrics = replace_result(picked.folders[k], own / "result", robot.files);
    auto task_run = read_record_file<RunRecord>(own / "run.json");
    note_task_design(task_run, robot, picked.name, metrics);
    note_result_scene(own, task_run);
    write_json(own / "run.json", json_of(task_run));
    task.F = metrics.F;
    task.speed_reached = metrics.speed_reached;
    task.physics_steps.reset();
    const auto own_reasons = reasons_of(run, picked.name, metrics, task);
    task.feasible = own_reasons.empty();
    for (const std::string& reason : own_reasons) reasons.push_back(task.name + ": " + reason);
    F += task.weight.value_or(1.0) * (metrics.F + metrics.J);
    note_design(run, robot, picked.name, metrics);
  }
  run.final_F = F;
  run.reasons = reasons;
  run.feasible = reasons.empty();
  const fs::path body = folder.result() / "robot.xml";
  fs::copy_file(folder.root() / "tasks" / run.tasks->front().name / "result" / "robot.xml", body,
                fs::copy_options::overwrite_existing);
}

/// Takes away what tells of the design before: pages, and in the folder that several tasks share
/// the certificate and what validate wrote. The results of tasks are replaced whole.
void remove_what_told(const ResultFolder& folder, const RunRecord& run) {
  fs::remove(folder.root() / "report.html");
  if (!run.joint()) return;
  for (const TaskRecord& task : *run.tasks)
    fs::remove(folder.root() / "tasks" / task.name / "report.html");
  for (const char* name : {"certificate.json", "matrix.json", "summary.md"})
    fs::remove(folder.result() / name);
}

/// Where the run, and that of each of its tasks, say that they are between two results.
std::vector<fs::path> between_results(const ResultFolder& folder, const RunRecord& run) {
  std::vector<fs::path> out{folder.picking()};
  for (const std::string& task : task_names(run))
    out.push_back(folder.root() / "tasks" / task / ResultFolder::kPicking);
  return out;
}

int pick(const PickOptions& options) {
  const int given = !options.candidate.empty() + !options.start.empty() + (options.front >= 0) +
                    (options.iteration >= 0);
  if (given != 1)
    throw InputError(fmt::format(
        "pick: expected one of --iteration, --start, --front and --candidate, found {}", given));
  const ResultFolder folder =
      ResultFolder::open_to_write(options.run, ResultFolder::BetweenResults::taken_up);
  options.check_run(options.run);
  auto run = read_record_file<RunRecord>(folder.run_json());
  if (!run.ended()) throw IoError(options.run + ": the run has not ended; let it end first");
  const PickedDesign picked = find_design(folder, run, options);
  for (const fs::path& from : picked.folders)
    if (!fs::is_regular_file(from / "scene.xml"))
      refuse_pick(from, "no such design in the run; events.jsonl lists its iterations");
  for (const fs::path& from : picked.folders)
    check_scene(folder.root(), run, from.lexically_relative(folder.root()));
  const RobotModel robot = read_robot(folder.inputs() / "robot.xml");

  const WholeChange whole;  // a signal waits for its end
  const std::vector<fs::path> between = between_results(folder, run);
  for (const fs::path& mark : between) write_file(mark, picked.name + "\n");
  remove_what_told(folder, run);
  if (!run.joint()) {
    note_task_design(run, robot, picked.name,
                     replace_result(picked.folders[0], folder.result(), robot.files));
    note_result_scene(folder.root(), run);
  } else {
    pick_joint(folder, picked, robot, run);
  }
  write_json(folder.run_json(), json_of(run));
  for (const fs::path& mark : between) fs::remove(mark);
  fmt::print("{}: the result is {} now, F {:.5g}\n", options.run, picked.name, *run.final_F);
  for (const std::string& reason : run.reasons.value_or(std::vector<std::string>{}))
    fmt::print("INFEASIBLE: {}\n", reason);
  if (run.choice)
    fmt::print("back: legwright pick {} --candidate {}\n", shell_word(options.run),
               shell_word(run.choice->chosen));
  fmt::print("next: legwright validate {}\n", shell_word(options.run));
  return kOk;
}

}  // namespace

void add_pick(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "pick", "Make another design of a run its result", pick);
  verb->add_option("RUN", options->run, "folder that `legwright optimize` wrote")->required();
  verb->add_option("--iteration", options->iteration, "an iteration on the way, from 0 on")
      ->check(CLI::Range(0, 1000000));
  verb->add_option("--start", options->start, "the optimum of one of several starts, by its name");
  verb->add_option("--front", options->front, "a point of the trade-off of two tasks, from 0 on")
      ->check(CLI::Range(0, 1000));
  verb->add_option("--candidate", options->candidate,
                   "a design that MuJoCo played, by its name in run.json: optimum, ...");
}

}  // namespace legwright
