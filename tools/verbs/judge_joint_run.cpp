// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/files/checksum.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/verbs/judge_run.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A body of the matrix that is neither the initial nor the common one: the best of one task alone,
/// as the joint run from it found it.
struct AloneBody {
  std::string task;
  const StartRecord* start;
};

/// Those whose joint run was reached: a run that was stopped may lack some.
std::vector<AloneBody> bodies_alone(const ResultFolder& folder, const RunRecord& run) {
  std::vector<AloneBody> bodies;
  for (const TaskFolder& task : task_folders(run))
    for (const StartRecord& start : *run.starts)
      if (start.start == task.name &&
          fs::is_directory(folder.root() / "starts" / ("from-" + task.name)))
        bodies.push_back({task.name, &start});
  return bodies;
}

/// Where the joint run from such a body began, with the motion of a task.
fs::path design_alone(const AloneBody& body, const std::string& task) {
  return fs::path("starts") / ("from-" + body.task) / task / "iterations" / "0000";
}

/// Before anything is played: scenes that were edited must not cost the roll-outs of the others.
void check_all_scenes(const fs::path& root, const RunRecord& run,
                      const std::vector<AloneBody>& bodies) {
  check_result_scenes(root, run);
  for (const TaskFolder& task : task_folders(run)) {
    check_scene(root, run, task.relative / "iterations" / "0000");
    for (const AloneBody& body : bodies) check_scene(root, run, design_alone(body, task.name));
  }
}

/// The initial body, those of the tasks alone, then the common one: as the matrix has them, each
/// with the verdict on its roll-outs at the gains. More is asked of the common one alone.
std::vector<std::pair<const SceneValidation*, const Verdict*>> in_order(const JudgedRun& judged) {
  std::vector<std::pair<const SceneValidation*, const Verdict*>> order;
  for (std::size_t k = 0; k < judged.designs.size(); ++k)
    if (k != 1) order.emplace_back(&judged.designs[k], &judged.designs[k].verdict);
  order.emplace_back(&judged.designs[1], &judged.verdict_at_gains);
  return order;
}

/// F of a task at the designs, in the same order.
std::vector<double> costs_of(const RunRecord& run, const std::vector<AloneBody>& bodies,
                             std::size_t task) {
  const std::string& name = (*run.tasks)[task].name;
  const auto at_start = [&](const StartRecord& start) {
    const double* F = start.start_F_of_tasks.find(name);
    if (F == nullptr) throw InputError("run.json: starts: no F_tasks_start of task " + name);
    return *F;
  };
  std::vector<double> out{at_start(run.starts->front())};
  for (const AloneBody& body : bodies) out.push_back(at_start(*body.start));
  out.push_back((*run.tasks)[task].F.value());
  return out;
}

bool came_to_its_end(const RunRecord& run) {
  if (!run.tasks || !run.starts || run.starts->empty() || !run.best_start) return false;
  for (const TaskRecord& task : *run.tasks)
    if (!task.F) return false;
  return true;
}

/// The files of each task, then the matrix, which names their verdicts.
void write_all(const ResultFolder& folder, const std::vector<TaskFolder>& tasks,
               std::vector<JudgedRun>& judged, MatrixRecord& matrix) {
  matrix.with.emplace();
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const ResultFolder own = ResultFolder::open(folder.root() / tasks[t].relative);
    write_judged(own, judged[t]);
    const fs::path verdict = tasks[t].relative / "result" / "verdict.json";
    matrix.with->of(verdict.generic_string()) = sha256_hex(read_file(folder.root() / verdict));
  }
  write_json(folder.result() / "matrix.json", json_of(matrix));
}

}  // namespace

MatrixRecord judge_joint_run(const ResultFolder& folder, const RunRecord& run,
                             const JudgeOptions& options, std::vector<JudgedRun>& judged) {
  if (!came_to_its_end(run))
    throw InputError(folder.run_json().string(), 0, "",
                     "not the run.json of a joint run that came to its end; run `legwright "
                     "optimize` again");
  const std::vector<AloneBody> bodies = bodies_alone(folder, run);
  const std::vector<TaskFolder> tasks = task_folders(run);  // checked: nothing outside the run
  check_all_scenes(folder.root(), run, bodies);
  MatrixRecord matrix;
  matrix.of = sums_of_joint_run(folder.root(), run);
  matrix.of->of(kLimitsSum) = limits_sum(options.validation.limits);
  matrix.pass = true;
  matrix.designs.push_back({"initial body", "initial"});
  for (const AloneBody& body : bodies)
    matrix.designs.push_back({"for " + body.task + " alone", body.task});
  matrix.designs.push_back({"for all tasks", *run.best_start});
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    std::vector<fs::path> others;
    others.reserve(bodies.size());
    for (const AloneBody& body : bodies)
      others.push_back(folder.root() / design_alone(body, tasks[t].name));
    const ResultFolder own = ResultFolder::open(folder.root() / tasks[t].relative);
    judged.push_back(play_and_judge(own, others, options));
    const auto order = in_order(judged.back());
    const auto costs = costs_of(run, bodies, t);
    auto& cells = matrix.cells.of(tasks[t].name);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto& [design, verdict] = order[k];
      cells.push_back({costs[k], verdict->pass, verdict->line, metrics_by_gain(*design)});
    }
    matrix.pass = matrix.pass && judged.back().designs[1].verdict.pass;
  }
  check_unchanged(folder.root(), *matrix.of, sums_of_joint_run(folder.root(), run));
  if (options.write) write_all(folder, tasks, judged, matrix);
  return matrix;
}

}  // namespace legwright
