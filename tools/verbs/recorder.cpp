// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/recorder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "optimizer/base/stopwatch.hpp"
#include "tools/run/run_json.hpp"

namespace legwright {

namespace fs = std::filesystem;

std::string start_folder(const CodesignProblem& problem, const RunLabel& label) {
  const bool alone = static_cast<int>(label.tasks.size()) < problem.task_count();
  return alone ? problem.task(label.tasks.front()).name + "-alone" : "from-" + label.start;
}

Recorder::Recorder(const ResultFolder& folder, const CodesignProblem& problem, Progress& progress,
                   bool pictures, StopAsked stop)
    : folder_(folder),
      problem_(problem),
      progress_(progress),
      events_(folder.events()),
      pictures_(pictures),
      stop_(std::move(stop)) {}

void Recorder::start() {
  StartEvent event;
  for (const TaskFile& task : problem_.set.tasks) event.tasks.push_back(task.name);
  event.robot = problem_.robot.morphology.name;
  events_.append(json_of(event));
}

fs::path Recorder::design_folder(const RunLabel& label, int k, int index) {
  if (!problem_.set.joint()) return folder_.iteration(count_);
  const fs::path folder = folder_.root() / "starts" / start_folder(problem_, label) /
                          problem_.task(k).name / "iterations";
  fs::create_directories(folder);
  return folder / fmt::format("{:04}", index);
}

bool Recorder::iteration(const RunLabel& label, const DesignIteration& iteration) {
  folder_.check_there();
  const Stopwatch watch;
  std::vector<PlanQuality> qualities;
  for (std::size_t k = 0; k < label.tasks.size(); ++k) {
    const int task = label.tasks[k];
    // Rename is enough here: a killed process loses nothing, and a flush to disk would take longer
    // than the step.
    const fs::path folder = design_folder(label, task, iteration.index);
    qualities.push_back(write_design(folder, problem_.robot, *problem_.objectives[task], iteration,
                                     static_cast<int>(k), Durability::process));
    IterationEvent event =
        iteration_event(problem_.robot.space, iteration, static_cast<int>(k), qualities.back());
    if (!problem_.set.joint()) {
      event.index = count_;
      event.start = label.start;
      events_.append(json_of(event));
    }
    task_events_[{start_folder(problem_, label), task}].push_back(std::move(event));
    if (!problem_.set.joint()) pictures_.add(folder);  // else those of the start that wins
  }
  if (problem_.set.joint())
    events_.append(json_of(joint_iteration_event(problem_, label, iteration, qualities)));
  history_.push_back(iteration.value);
  progress_.iteration(label, iteration, qualities);
  ++count_;
  seconds_ += watch.seconds();
  return !stop_();
}

PlanQuality Recorder::result(const fs::path& folder, const Objective& planned,
                             const DesignIteration& best, int k) {
  const Stopwatch watch;
  PlanQuality quality = write_design(folder, problem_.robot, planned, best, k);
  seconds_ += watch.seconds();
  return quality;
}

void Recorder::end(const RunRecord& run) {
  events_.append(json_of(end_event(run)));
  events_.sync();
}

void Recorder::draw_rest(bool quiet) {
  constexpr double kUntold = 1.0;  // of waiting for one picture [s]
  const Stopwatch watch;
  bool told = quiet;
  for (std::size_t left; (left = pictures_.waiting()) > 0 && !stop_();) {
    if (!told && (left > 1 || watch.seconds() > kUntold)) {
      fmt::print(stderr, "drawing {} more picture{} (may be interrupted)\n", left,
                 left == 1 ? "" : "s");
      told = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (stop_()) return;
  const std::string warning = pictures_.finish();
  if (!warning.empty()) fmt::print(stderr, "legwright: warning: {}\n", warning);
}

const std::vector<IterationEvent>& Recorder::events_of(const std::string& start, int task) const {
  static const std::vector<IterationEvent> none;
  const auto found = task_events_.find({start, task});
  return found == task_events_.end() ? none : found->second;
}

}  // namespace legwright
