// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "optimizer/base/parallel.hpp"
#include "tools/choose/candidate_on_trial.hpp"
#include "tools/choose/kept_play.hpp"
#include "tools/choose/physics_trial.hpp"
#include "tools/simulate/rollout.hpp"

namespace legwright {
namespace {

double sum_of(const std::vector<TermValue>& terms) {
  double sum = 0.0;
  for (const TermValue& term : terms) sum += term.value;
  return sum;
}

}  // namespace

PlayedGait PlayedCandidate::record(std::optional<int> task) const {
  if (!task) return {distance, pass, line};
  const GaitTrial& trial = trials.at(static_cast<std::size_t>(*task));
  return {trial.distance, trial.pass, trial.line};
}

std::shared_ptr<const Objective> Candidate::objective(const CodesignProblem& problem, int k) const {
  const auto i = static_cast<std::size_t>(k);
  if (!planned.empty()) return planned.at(i)->get();
  return {std::shared_ptr<const Objective>(), problem.objectives[i].get()};  // owns nothing
}

const Task& Candidate::planned_task(const CodesignProblem& problem, int k) const {
  const auto i = static_cast<std::size_t>(k);
  return planned.empty() ? problem.objectives[i]->task() : planned.at(i)->task();
}

PlayedCandidate play_candidate(const CodesignProblem& problem, const Candidate& candidate,
                               int threads, PlayLength length, const std::function<bool()>& stop) {
  CandidateOnTrial on_trial(problem, candidate, threads, stop);
  if (length == PlayLength::whole || on_trial.play(PlayedCycles::first)) {
    const bool pass = on_trial.play(PlayedCycles::all);
    if (pass || length == PlayLength::whole) on_trial.ask_other_numerics();
  }
  return played_tasks(on_trial.trials());
}

double largest_multiplier(const CodesignProblem& problem, const Candidate& candidate, int threads,
                          const std::function<bool()>& stop) {
  return CandidateOnTrial(problem, candidate, threads, stop).largest_multiplier();
}

std::vector<std::optional<PlayedCandidate>> play_beside(
    const CodesignProblem& problem, const Candidate& candidate,
    const std::vector<std::optional<DesignIteration>>& designs, int threads,
    const std::function<bool()>& stop, const Checkpoint& checkpoint) {
  std::vector<std::optional<PlayedCandidate>> out(designs.size());
  parallel_for(static_cast<int>(designs.size()), threads, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    if (!designs[i] || (stop && stop())) return;
    Candidate beside = candidate;
    beside.design = *designs[i];
    try {
      out[i] = kept_play(checkpoint.in(k), stop, [&] {
        CandidateOnTrial on_trial(problem, beside, 1, stop);
        on_trial.glance();
        return played_tasks(on_trial.trials());
      });
    } catch (const RolloutStopped&) {  // nothing is known of it
    }
  });
  return out;
}

void evaluate_as_planned(const CodesignProblem& problem, const Candidate& candidate,
                         DesignIteration& design) {
  design.value = 0.0;
  for (int k = 0; k < problem.task_count(); ++k) {
    TaskIterate& task = design.tasks[static_cast<std::size_t>(k)];
    task.terms = candidate.objective(problem, k)->terms(design.s, task.m);
    task.value = sum_of(task.terms);
    design.value += problem.task(k).weight * (task.value + task.outer_value);
  }
}

void evaluate_as_asked(const CodesignProblem& problem, Candidate& candidate) {
  DesignIteration& design = candidate.design;
  design.value = 0.0;
  for (int k = 0; k < problem.task_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    TaskIterate& task = design.tasks[i];
    const Objective& asked = *problem.objectives[i];
    const Task& planned = candidate.planned_task(problem, k);
    if (planned.velocity == asked.task().velocity && planned.turn_rate == asked.task().turn_rate) {
      task.terms = asked.terms(design.s, task.m);
    } else {
      Task aimed = asked.task();
      aimed.velocity = planned.velocity;
      aimed.turn_rate = planned.turn_rate;
      task.terms = Objective(asked.morphology(), asked.space(), aimed).terms(design.s, task.m);
    }
    task.value = sum_of(task.terms);
    if (!problem.outers.empty()) {
      const OuterObjective& outer = *problem.outers[i];
      task.outer_value = outer.cost(outer.amount_at(design.s, task.m));
    }
    design.value += problem.task(k).weight * (task.value + task.outer_value);
  }
}

}  // namespace legwright
