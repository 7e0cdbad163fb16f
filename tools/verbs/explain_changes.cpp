// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/explain_changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "optimizer/base/stopwatch.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/attribution_json.hpp"
#include "tools/run/by_name.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/joint_folders.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr double kWorthPlaying = 0.01;  // of F: a parameter that buys less is not played put back

int thread_count(int asked) {
  return asked > 0 ? asked : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// run.json of a task of a joint run, changed.
template <class Change>
void edit_task_run(const ResultFolder& folder, const CodesignProblem& problem, int task,
                   const Change& change) {
  const auto file = result_folder(folder, problem, task).parent_path() / "run.json";
  auto run = read_record_file<RunRecord>(file);
  change(run);
  write_json(file, json_of(run));
}

/// F of the given body with its best motions.
double best_of_given_body(std::vector<WeightedCost> tasks, const DesignIteration& initial,
                          const MotionLimits& limits) {
  double sum = 0.0;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    tasks[k].initial_motion = initial.tasks.at(k).m;
    TaskSolver solver(tasks[k], limits, limits.checkpoint.in(static_cast<int>(k)));
    if (!solver.start(initial.s)) return std::numeric_limits<double>::infinity();
    sum += tasks[k].weight * (solver.now().value + solver.now().outer_value);
  }
  return sum;
}

/// The designs of rows, each with its motions; nothing where there are none, or where F changes so
/// little that physics need not be asked.
std::vector<std::optional<DesignIteration>> designs_of(const std::vector<PutBack>& rows,
                                                       const std::vector<WeightedCost>& tasks,
                                                       double result_F) {
  std::vector<std::optional<DesignIteration>> out;
  for (const PutBack& row : rows) {
    std::optional<DesignIteration>& design = out.emplace_back();
    const double rise = row.total(tasks);
    if (!std::isfinite(rise) || std::abs(rise) <= kWorthPlaying * result_F) continue;
    design.emplace().s = row.s;
    for (const VectorXd& m : row.motions) design->tasks.emplace_back().m = m;
  }
  return out;
}

/// Whether two designs have the same body and move alike.
bool same_gaits(const DesignIteration& a, const DesignIteration& b) {
  return a.s == b.s &&
         std::equal(a.tasks.begin(), a.tasks.end(), b.tasks.begin(), b.tasks.end(),
                    [](const TaskIterate& x, const TaskIterate& y) { return x.m == y.m; });
}

/// What physics said of the result when it was chosen, after more cycles than a glance has.
const PlayedGait* played_result(const ChoiceRecord& choice) {
  for (const CandidateRecord& each : choice.candidates)
    if (each.name == choice.chosen) return &each.played;
  return nullptr;
}

/// What physics says of each row. @param task that it is said of; nothing: of all together
void add_played(const std::vector<std::optional<PlayedCandidate>>& played, std::optional<int> task,
                std::vector<PutBackRecord>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (played[i]) rows[i].played = played[i]->record(task);
}

}  // namespace

/// The tasks of a problem once for each thread, with costs of their own: F as a design was planned.
class ChangeReasons::CostsByThread {
 public:
  CostsByThread(const CodesignProblem& problem, const Candidate& chosen, int threads) {
    for (int thread = 0; thread < threads; ++thread) {
      costs_.push_back(std::make_unique<ProblemCosts>(problem));
      std::vector<WeightedCost>& tasks = tasks_.emplace_back();
      for (const JointTask& task : costs_.back()->tasks()) {
        const auto k = static_cast<int>(tasks.size());
        tasks.push_back(weighted(task, task.weight, {}));
        if (chosen.planned.empty()) continue;
        objectives_.push_back(chosen.objective(problem, k));
        planned_.push_back(std::make_unique<ObjectiveCost>(*objectives_.back()));
        tasks.back().cost = planned_.back().get();
      }
    }
  }
  const std::vector<std::vector<WeightedCost>>& tasks() const { return tasks_; }

 private:
  std::vector<std::unique_ptr<ProblemCosts>> costs_;
  std::vector<std::shared_ptr<const Objective>> objectives_;
  std::vector<std::unique_ptr<ObjectiveCost>> planned_;
  std::vector<std::vector<WeightedCost>> tasks_;
};

ChangeReasons::ChangeReasons(const CodesignProblem& problem, int threads, double share,
                             bool physics, StopAsked stop, Checkpoint checkpoint)
    : problem_(problem),
      threads_(thread_count(threads)),
      physics_(physics),
      stop_(std::move(stop)),
      checkpoint_(std::move(checkpoint)) {
  fewest_.share = share;
}

ChangeReasons::~ChangeReasons() = default;

const ChangeReasons::CostsByThread& ChangeReasons::costs() {
  if (!costs_) costs_ = std::make_unique<CostsByThread>(problem_, Candidate{}, threads_);
  return *costs_;
}

std::vector<PutBack> ChangeReasons::rows_of(const DesignIteration& design) {
  PutBackOptions options;
  options.stop = stop_;
  options.limits.newton.go_on = [this] { return !stop_(); };
  options.limits.checkpoint = checkpoint_.in(solved_++);
  return put_back(costs().tasks(), problem_.robot.space.initial(), design, options);
}

void ChangeReasons::find_fewest(double initial_F, const DesignIteration& best,
                                const std::vector<PutBack>& rows) {
  const Stopwatch watch;
  const DesignSpace& space = problem_.robot.space;
  FewestChangesOptions options;
  options.codesign.threads = threads_;
  options.codesign.go_on = options.codesign.newton.go_on = [this] { return !stop_(); };
  options.stop = stop_;
  options.share = fewest_.share;
  options.codesign.checkpoint = checkpoint_.in(solved_++);
  fewest_.initial_F = initial_F;
  designs_ = fewest_changes(costs().tasks(), space, space.initial(), fewest_.initial_F, best, rows,
                            options);
  fewest_.fewest = fewest_that_keep(designs_, fewest_.initial_F, fewest_.share);
  fewest_.designs.clear();
  for (const FewerChanges& each : designs_) {
    FewerChangesRecord& design = fewest_.designs.emplace_back();
    for (const int k : each.changed) design.changed.push_back(space.parameters[k].name);
    design.F = each.design.value;
    design.s = by_name(space, each.design.s);
  }
  fewest_.seconds = watch.seconds();
}

void ChangeReasons::keep_fewest(MultistartResult& found, const OnIteration& on_iteration) {
  const DesignSpace& space = problem_.robot.space;
  StartedRun& winner = found.joint[static_cast<std::size_t>(found.best)];
  if (stop_() || !std::isfinite(winner.result.best.value) ||
      winner.result.best.s == space.initial())
    return;
  find_fewest(found.joint.front().result.initial.value, winner.result.best,
              rows_of(winner.result.best));
  if (stop_()) return;
  CodesignOptions options;
  options.method = DesignMethod::newton;  // what is to settle is nearly an optimum
  options.threads = threads_;
  options.go_on = options.newton.go_on = [this] { return !stop_(); };
  options.checkpoint = checkpoint_.in("few");
  CodesignResult few =
      settle(costs().tasks().front(), space, space.initial(), designs_[fewest_.fewest], options);
  few.best.index = winner.result.best.index + 1;
  fewest_.kept = true;
  winner.result.status = few.status;
  winner.result.best = std::move(few.best);
  ++winner.result.design_iterations;
  on_iteration(winner.label, winner.result.best);
}

std::optional<DesignSpace> ChangeReasons::space_of_fewest() const {
  if (!fewest_.kept) return std::nullopt;
  const DesignSpace& space = problem_.robot.space;
  return held_space(space, space.initial(), designs_[fewest_.fewest].changed);
}

std::vector<std::optional<PlayedCandidate>> ChangeReasons::play(
    const Candidate& chosen, const std::vector<std::optional<DesignIteration>>& designs) {
  if (!physics_) return std::vector<std::optional<PlayedCandidate>>(designs.size());
  load_gait_plugin();
  return play_beside(problem_, chosen, designs, threads_, stop_,
                     checkpoint_.in("plays").in(plays_++));
}

void ChangeReasons::play_fewest(const Candidate& chosen,
                                const std::optional<ChoiceRecord>& choice) {
  const PlayedGait* const of_result = choice ? played_result(*choice) : nullptr;
  std::vector<std::optional<DesignIteration>> designs;
  for (std::size_t i = 0; i < designs_.size(); ++i) {
    std::optional<DesignIteration>& design = designs.emplace_back(designs_[i].design);
    if (of_result == nullptr || !same_gaits(*design, chosen.design)) continue;
    fewest_.designs[i].played = *of_result;
    design.reset();
  }
  const auto played = play(chosen, designs);
  for (std::size_t i = 0; i < played.size(); ++i)
    if (played[i]) fewest_.designs[i].played = played[i]->record();
}

void ChangeReasons::write(const ResultFolder& folder, const MultistartResult& found,
                          const Candidate& chosen, RunRecord& run) {
  const DesignSpace& space = problem_.robot.space;
  if (chosen.design.s == space.initial()) return;
  DesignIteration best = chosen.design;
  double initial_F = found.joint.front().result.initial.value;
  if (!chosen.planned.empty()) {  // its own F, not that of the task as it was asked
    costs_ = std::make_unique<CostsByThread>(problem_, chosen, threads_);
    evaluate_as_planned(problem_, chosen, best);
    MotionLimits limits;
    limits.newton.go_on = [this] { return !stop_(); };
    limits.checkpoint = checkpoint_.in("given body");
    initial_F =
        best_of_given_body(costs().tasks().front(), found.joint.front().result.initial, limits);
  }
  const std::vector<PutBack> rows = rows_of(best);
  const bool known = fewest_.kept && chosen.planned.empty();
  if (known) run.fewest_changes = fewest_;
  if (!known) find_fewest(initial_F, best, rows);
  if (fewest_.kept && !known) fewest_.fewest = 0;  // searched on in its space
  play_fewest(chosen, run.choice);
  // Half worked out it would call more changes needed than are.
  if (!stop_()) run.fewest_changes = fewest_;
  const std::vector<WeightedCost>& tasks = costs().tasks().front();
  const auto played = play(chosen, designs_of(rows, tasks, best.value));
  if (!problem_.set.joint()) {
    run.put_back = put_back_records(rows, space, tasks, 0);
    add_played(played, std::nullopt, *run.put_back);
    return;
  }
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(problem_.task_count()));
  for (int k = 0; k < problem_.task_count(); ++k) names.push_back(problem_.task(k).name);
  run.put_back = joint_put_back_records(rows, space, tasks, names);
  add_played(played, std::nullopt, *run.put_back);
  for (int k = 0; k < problem_.task_count(); ++k)
    edit_task_run(folder, problem_, k, [&](RunRecord& own) {
      own.put_back = put_back_records(rows, space, tasks, k);
      add_played(played, k, *own.put_back);
    });
}

}  // namespace legwright
