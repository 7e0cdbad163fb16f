// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/run/events.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"
#include "tools/verbs/picture_queue.hpp"
#include "tools/verbs/progress.hpp"
#include "tools/verbs/stop_asked.hpp"

namespace legwright {

/// Name of the folder of one run among several starts: "from-initial", "from-pace", "pace-alone".
std::string start_folder(const CodesignProblem& problem, const RunLabel& label);

/// Writes what the solvers find into the run's folder, as they find it: every accepted iteration is
/// a complete design on disk before the next one is looked for. One task: iterations/NNNN. Several:
/// starts/START/TASK/iterations/NNNN.
class Recorder {
 public:
  Recorder(const ResultFolder& folder, const CodesignProblem& problem, Progress& progress,
           bool pictures, StopAsked stop);

  void start();
  /// @return false to stop
  bool iteration(const RunLabel& label, const DesignIteration& iteration);
  /// Writes the result of one task. @param k of best.tasks and of the problem's tasks
  /// @param planned F whose plan it is
  PlanQuality result(const std::filesystem::path& folder, const Objective& planned,
                     const DesignIteration& best, int k);
  void end(const RunRecord& run);

  double seconds() const { return seconds_; }  // spent on files
  /// Draws a design's picture when there is time.
  void draw(const std::filesystem::path& design_folder) { pictures_.add(design_folder); }
  /// Waits for the pictures that are not drawn yet, or for a signal. Tells stderr what went wrong,
  /// and, unless quiet, how many there are.
  void draw_rest(bool quiet);
  /// F by iteration, in the order in which they came.
  const std::vector<double>& history() const { return history_; }
  /// The per-task events of a run, by start folder and task.
  const std::vector<IterationEvent>& events_of(const std::string& start, int task) const;

 private:
  std::filesystem::path design_folder(const RunLabel& label, int k, int index);

  const ResultFolder& folder_;
  const CodesignProblem& problem_;
  Progress& progress_;
  EventLog events_;
  PictureQueue pictures_;
  StopAsked stop_;
  int count_ = 0;  // iterations so far
  std::vector<double> history_;
  std::map<std::pair<std::string, int>, std::vector<IterationEvent>> task_events_;
  double seconds_ = 0.0;
};

}  // namespace legwright
