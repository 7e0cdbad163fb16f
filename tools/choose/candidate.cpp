// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/candidate.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "optimizer/base/parallel.hpp"
#include "tools/choose/physics_trial.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

double sum_of(const std::vector<TermValue>& terms) {
  double sum = 0.0;
  for (const TermValue& term : terms) sum += term.value;
  return sum;
}

GaitTrial play_task(const CodesignProblem& problem, const Candidate& candidate, int k, int threads,
                    PlayLength length) {
  GaitTrial trial;
  trial.distance = std::numeric_limits<double>::infinity();
  const DesignIteration& design = candidate.design;
  try {
    trial = try_in_physics(problem.robot, problem.task(k),
                           design_texts(problem.robot, candidate.objective(problem, k), design.s,
                                        design.tasks.at(static_cast<std::size_t>(k)).m),
                           threads, length);
  } catch (const InputError& error) {
    trial.line = error.what();  // no such robot, which never passes
  } catch (const MujocoError& error) {
    trial.line = error.what();
  }
  return trial;
}

}  // namespace

PlayedGait PlayedCandidate::record(std::optional<int> task) const {
  if (!task) return {distance, pass, line};
  const GaitTrial& trial = trials.at(static_cast<std::size_t>(*task));
  return {trial.distance, trial.pass, trial.line};
}

const Objective& Candidate::objective(const CodesignProblem& problem, int k) const {
  const auto i = static_cast<std::size_t>(k);
  return planned.empty() ? *problem.objectives[i] : *planned.at(i);
}

PlayedCandidate play_candidate(const CodesignProblem& problem, const Candidate& candidate,
                               int threads, PlayLength length) {
  std::vector<GaitTrial> trials(static_cast<std::size_t>(problem.task_count()));
  parallel_for(problem.task_count(), threads, [&](int k) {
    trials[static_cast<std::size_t>(k)] =
        play_task(problem, candidate, k, std::max(1, threads / problem.task_count()), length);
  });
  PlayedCandidate out{true, 0.0, "", {}};
  for (const GaitTrial& trial : trials) {
    out.pass = out.pass && trial.pass;
    out.distance += trial.distance;
  }
  for (const GaitTrial& trial : trials)
    if (trial.pass == out.pass) out.line += (out.line.empty() ? "" : "; ") + trial.line;
  out.trials = std::move(trials);
  return out;
}

std::vector<std::optional<PlayedCandidate>> play_beside(
    const CodesignProblem& problem, const Candidate& candidate,
    const std::vector<std::optional<DesignIteration>>& designs, int threads,
    const std::function<bool()>& stop) {
  std::vector<std::optional<PlayedCandidate>> out(designs.size());
  parallel_for(static_cast<int>(designs.size()), threads, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    if (!designs[i] || (stop && stop())) return;
    Candidate beside = candidate;
    beside.design = *designs[i];
    out[i] = play_candidate(problem, beside, 1, PlayLength::first_cycles);
  });
  return out;
}

void evaluate_as_planned(const CodesignProblem& problem, const Candidate& candidate,
                         DesignIteration& design) {
  design.value = 0.0;
  for (int k = 0; k < problem.task_count(); ++k) {
    TaskIterate& task = design.tasks[static_cast<std::size_t>(k)];
    task.terms = candidate.objective(problem, k).terms(design.s, task.m);
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
    const Task& planned = candidate.objective(problem, k).task();
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
