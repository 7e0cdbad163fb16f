// SPDX-License-Identifier: Apache-2.0
// Table I of the paper: whole co-design runs, the solver alone, on one core.
#include <algorithm>
#include <optional>

#include "benchmarks/figures.hpp"
#include "benchmarks/timing.hpp"
#include "optimizer/base/stopwatch.hpp"

namespace legwright::bench {
namespace {

constexpr double kGoalIterations = 150;
constexpr double kGoalColdStart = 20;
constexpr int runs = 3;  // the fastest counts; all do the same to the last bit

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct TimedRun {
  MultistartResult result;
  double wall = 0.0, cpu = 0.0;            // [s], the least of all runs, each
  std::optional<double> step_median = {};  // [s] of one motion solve after a design step
};

TimedRun timed(const CodesignProblem& problem, bool all_starts) {
  const ProblemCosts costs(problem);
  MultistartOptions options;
  options.from_single_tasks = all_starts;
  options.codesign.threads = 1;
  TimedRun best;
  for (int k = 0; k < runs; ++k) {
    const Stopwatch watch;
    const double before = thread_microseconds();
    MultistartResult result = codesign_from_starts(costs.tasks(), problem.robot.space, options);
    const double cpu = 1e-6 * (thread_microseconds() - before), wall = watch.seconds();
    const std::optional<double> step = median(result.joint[0].result.solve_seconds);
    best.wall = k == 0 ? wall : std::min(best.wall, wall);
    best.cpu = k == 0 ? cpu : std::min(best.cpu, cpu);
    if (step) best.step_median = std::min(*step, best.step_median.value_or(*step));
    best.result = std::move(result);
  }
  return best;
}

Json numbers(const TimedRun& run) {
  int newton = 0, design = 0, factorisations = 0, evaluations = 0;
  for (const auto* starts : {&run.result.alone, &run.result.joint})
    for (const StartedRun& started : *starts) {
      newton += started.result.newton_iterations;
      design += started.result.design_iterations;
      factorisations += started.result.factorisations;
      evaluations += started.result.evaluations;
    }
  const CodesignResult& winner = run.result.winner();
  return {{"wall_seconds", run.wall},
          {"cpu_seconds", run.cpu},
          {"newton_iterations", newton},
          {"design_iterations", design},
          {"factorisations", factorisations},
          {"evaluations", evaluations},
          {"cpu_ms_per_newton_iteration", 1e3 * run.cpu / std::max(1, newton)},
          {"median_motion_solve_seconds", run.step_median ? Json(*run.step_median) : Json()},
          {"motion_only_F", run.result.joint[0].result.initial.value},
          {"F", winner.best.value},
          {"status", std::string(to_string(winner.status))},
          {"motion_status", std::string(to_string(winner.best.motion_status()))}};
}

}  // namespace

Group codesign_figures(SolvedCase& solved) {
  Group group;
  const Case& of = solved.of;
  const TimedRun run = timed(solved.problem, false);
  const CodesignResult& result = run.result.winner();
  solved.s = result.best.s;
  for (const TaskIterate& task : result.best.tasks) solved.m.push_back(task.m);

  int parameters = solved.problem.robot.space.size();
  for (const auto& objective : solved.problem.objectives)
    parameters += objective->layout().motion_size();
  group.details = numbers(run);
  group.details["parameters"] = parameters;
  group.details["design_parameters"] = solved.problem.robot.space.size();
  if (solved.problem.task_count() > 1)
    group.details["all_starts"] = numbers(timed(solved.problem, true));
  group.figures = {{"co-design, wall time", of.goal_seconds, run.wall, false, "s", of.label},
                   {"Newton iterations in the whole co-design", kGoalIterations,
                    static_cast<double>(result.newton_iterations), false, "", of.label}};
  if (run.step_median)
    group.figures.push_back({"motion solve after one design step, median",
                             of.goal_step_milliseconds, 1e3 * *run.step_median, false, "ms",
                             of.label});
  else
    group.notes.push_back(of.label + ": no motion was solved by itself after a design step");
  return group;
}

Group cold_start_figures(const SolvedCase& solved) {
  Group group;
  int worst = 0;
  for (int k = 0; k < solved.problem.task_count(); ++k) {
    const Objective& objective = *solved.problem.objectives[k];
    Eigen::VectorXd m = initial_guess(objective, solved.s);
    const SolveReport report = newton(objective, solved.s, m);
    worst = std::max(worst, report.iterations);
    group.details[solved.problem.task(k).name] = {
        {"newton_iterations", report.iterations},
        {"factorisations", report.factorisations},
        {"evaluations", report.evaluations},
        {"status", std::string(to_string(report.status))},
        {"F", report.value},
        {"F_of_codesign", objective.evaluate(solved.s, solved.m[k], Order::value).value}};
  }
  group.figures = {{"Newton iterations, cold start from standing", kGoalColdStart,
                    static_cast<double>(worst), false, "", solved.of.label}};
  return group;
}

}  // namespace legwright::bench
