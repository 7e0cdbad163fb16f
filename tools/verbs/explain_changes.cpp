// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/explain_changes.hpp"

#include <algorithm>
#include <memory>
#include <thread>

#include "optimizer/solve/put_back.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/attribution_json.hpp"
#include "tools/verbs/joint_folders.hpp"
#include "tools/verbs/stop_signals.hpp"

namespace legwright {
namespace {

/// The tasks of a problem once for each thread, with costs of their own.
class CostsByThread {
 public:
  CostsByThread(const CodesignProblem& problem, int threads) {
    for (int k = 0; k < threads; ++k) {
      costs_.push_back(std::make_unique<ProblemCosts>(problem));
      std::vector<WeightedCost>& tasks = tasks_.emplace_back();
      for (const JointTask& task : costs_.back()->tasks())
        tasks.push_back(weighted(task, task.weight, {}));
    }
  }
  const std::vector<std::vector<WeightedCost>>& tasks() const { return tasks_; }

 private:
  std::vector<std::unique_ptr<ProblemCosts>> costs_;
  std::vector<std::vector<WeightedCost>> tasks_;
};

/// run.json of a task of a joint run, changed.
template <class Change>
void edit_task_run(const ResultFolder& folder, const CodesignProblem& problem, int task,
                   const Change& change) {
  const auto file = result_folder(folder, problem, task).parent_path() / "run.json";
  auto run = read_record_file<RunRecord>(file);
  change(run);
  write_json(file, json_of(run));
}

}  // namespace

void explain_changes(const ResultFolder& folder, const CodesignProblem& problem,
                     const DesignIteration& best, int threads, RunRecord& run) {
  const DesignSpace& space = problem.robot.space;
  if (best.s == space.initial()) return;
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const CostsByThread costs(problem, threads > 0 ? threads : cores);
  PutBackOptions options;
  options.stop = [] { return StopSignals::received() != 0; };
  const std::vector<PutBack> rows = put_back(costs.tasks(), space.initial(), best, options);
  const std::vector<WeightedCost>& tasks = costs.tasks().front();
  if (!problem.set.joint()) {
    run.put_back = put_back_records(rows, space, tasks, 0);
    return;
  }
  std::vector<std::string> names;
  for (int k = 0; k < problem.task_count(); ++k) names.push_back(problem.task(k).name);
  run.put_back = joint_put_back_records(rows, space, tasks, names);
  for (int k = 0; k < problem.task_count(); ++k)
    edit_task_run(folder, problem, k,
                  [&](RunRecord& own) { own.put_back = put_back_records(rows, space, tasks, k); });
}

}  // namespace legwright
