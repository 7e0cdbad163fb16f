// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/joint_folders.hpp"

#include <fmt/format.h>

#include "mjcf/write/rewrite_robot.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/run/by_name.hpp"
#include "tools/run/events.hpp"
#include "tools/run/matrix_record.hpp"
#include "tools/run/robot_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// The iterations of a task run, in order: of the initial body, then of the winning start.
class Chain {
 public:
  Chain(const ResultFolder& folder, const CodesignProblem& problem, Recorder& recorder, int task)
      : root_(folder.root()),
        problem_(problem),
        recorder_(recorder),
        task_(task),
        run_(root_ / "tasks" / problem.task(task).name) {
    fs::create_directories(run_ / "iterations");
  }

  const fs::path& run() const { return run_; }
  const std::vector<IterationEvent>& events() const { return events_; }

  void add(const RunLabel& label, std::size_t first, std::size_t last) {
    const std::string start = start_folder(problem_, label);
    const std::vector<IterationEvent>& events = recorder_.events_of(start, task_);
    for (std::size_t k = first; k < std::min(last, events.size()); ++k) {
      const fs::path from = root_ / "starts" / start / problem_.task(task_).name / "iterations" /
                            fmt::format("{:04}", k);
      const fs::path to = run_ / "iterations" / fmt::format("{:04}", events_.size());
      copy_design(from, to, problem_.robot.files);
      recorder_.draw(to);
      events_.push_back(events[k]);
      events_.back().index = static_cast<int>(events_.size()) - 1;
    }
  }

 private:
  fs::path root_;
  const CodesignProblem& problem_;
  Recorder& recorder_;
  int task_;
  fs::path run_;
  std::vector<IterationEvent> events_;
};

void write_events(const fs::path& file, const RunRecord& run,
                  const std::vector<IterationEvent>& events) {
  EventLog log(file);
  log.append(json_of(StartEvent{{run.task->name}, run.robot}));
  for (const IterationEvent& event : events) log.append(json_of(event));
  log.append(json_of(end_event(run)));
  log.sync();
}

void write_task_run(const ResultFolder& folder, const CodesignProblem& problem,
                    const RunRecord& joint, const MultistartResult& found, TaskOutcome& outcome,
                    Recorder& recorder) {
  Chain chain(folder, problem, recorder, outcome.task);
  const StartedRun& first = found.joint.front();
  const StartedRun& winner = found.joint[found.best];
  chain.add(first.label, 0, 1);
  chain.add(winner.label, &winner == &first ? 1 : 0, std::string::npos);
  for (const IterationEvent& event : chain.events()) outcome.history.push_back(event.F);

  fs::create_directories(chain.run() / "inputs");
  fs::copy_file(folder.inputs() / "task.toml", chain.run() / "inputs" / "task.toml");
  write_robot_files(chain.run() / "inputs", problem.robot.files);
  RunRecord run = start_of_run(joint.argv, problem, outcome.task);
  run.joint_run = "../..";
  run.files = joint.files;  // as they were given, not the copies
  run.motion_only = joint.motion_only;
  run.start = winner.label.start;
  finish_run(run, joint.status, outcome, effort_of(winner.result), problem.robot);
  write_events(chain.run() / "events.jsonl", run, chain.events());
  write_json(chain.run() / "run.json", json_of(run));
}

}  // namespace

fs::path result_folder(const ResultFolder& folder, const CodesignProblem& problem, int task) {
  if (!problem.set.joint()) return folder.result();
  const fs::path run = folder.root() / "tasks" / problem.task(task).name;
  fs::create_directories(run);
  return run / "result";
}

void write_task_runs(const ResultFolder& folder, const CodesignProblem& problem,
                     const RunRecord& run, const MultistartResult& found,
                     std::vector<TaskOutcome>& outcomes, Recorder& recorder) {
  for (TaskOutcome& outcome : outcomes)
    write_task_run(folder, problem, run, found, outcome, recorder);
  fs::create_directories(folder.result());
  write_robot_files(folder.result(), problem.robot.files.with_text(
                                         rewrite_robot(problem.robot, outcomes.front().best->s)));
}

std::vector<FrontPointRecord> write_front(const ResultFolder& folder,
                                          const CodesignProblem& problem,
                                          const std::vector<JointTask>& tasks,
                                          const MultistartResult& found, int points,
                                          const CodesignOptions& options) {
  FrontRecord front{problem.task(0).name, {}};
  for (const FrontPoint& point :
       trade_off_front(tasks, problem.robot.space, found, points, options)) {
    ByName<double> values;
    for (int k = 0; k < problem.task_count(); ++k)
      values.of(problem.task(k).name) = point.best.tasks.at(k).value;
    front.points.push_back({point.weight, point.best.value, values,
                            std::string(to_string(point.status)),
                            by_name(problem.robot.space, point.best.s)});
    const fs::path design = folder.root() / "front" / fmt::format("{:02}", front.points.size() - 1);
    fs::create_directories(design);
    for (int k = 0; k < problem.task_count(); ++k)
      write_design(design / problem.task(k).name, problem.robot, *problem.objectives[k], point.best,
                   k, Durability::process);
  }
  write_json(folder.result() / "front.json", json_of(front));
  return front.points;
}

}  // namespace legwright
