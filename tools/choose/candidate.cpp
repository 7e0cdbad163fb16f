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

/// The gaits of a candidate, one for each task.
class CandidateOnTrial {
 public:
  CandidateOnTrial(const CodesignProblem& problem, const Candidate& candidate, int threads,
                   const std::function<bool()>& stop)
      : threads_(threads),
        gaits_(static_cast<std::size_t>(problem.task_count())),
        trials_(gaits_.size()) {
    for_each_task([&](std::size_t i) {
      const auto k = static_cast<int>(i);
      const DesignIteration& design = candidate.design;
      gaits_[i] =
          std::make_unique<GaitOnTrial>(problem.robot, problem.task(k),
                                        design_texts(problem.robot, candidate.objective(problem, k),
                                                     design.s, design.tasks.at(i).m),
                                        stop);
    });
  }

  /// @return whether all tasks pass
  bool play(PlayedCycles cycles) {
    for_each_gait([&](GaitOnTrial& gait, GaitTrial& trial) {
      const int before = trial.rollouts;
      trial = gait.play(cycles, threads_of_gait());
      trial.rollouts += before;
    });
    return std::all_of(trials_.begin(), trials_.end(),
                       [](const GaitTrial& trial) { return trial.pass; });
  }
  /// Of each task that passes.
  void ask_other_numerics() {
    for_each_gait([&](const GaitOnTrial& gait, GaitTrial& trial) {
      if (trial.pass) gait.ask_other_numerics(threads_of_gait(), trial);
    });
  }
  void glance() {
    for_each_gait([](const GaitOnTrial& gait, GaitTrial& trial) { trial = gait.glance(); });
  }
  double largest_multiplier() const {
    double largest = 0.0;
    try {
      for (const auto& gait : gaits_) {
        if (gait == nullptr) return std::numeric_limits<double>::infinity();
        largest = std::max(largest, gait->largest_multiplier(threads_));
      }
    } catch (const MujocoError&) {  // a disturbed state that MuJoCo gives up
      return std::numeric_limits<double>::infinity();
    }
    return largest;
  }
  const std::vector<GaitTrial>& trials() const { return trials_; }

 private:
  int threads_of_gait() const { return std::max(1, threads_ / static_cast<int>(gaits_.size())); }
  template <class Work>
  void for_each_gait(const Work& work) {
    for_each_task([&](std::size_t i) {
      if (gaits_[i] != nullptr) work(*gaits_[i], trials_[i]);
    });
  }
  template <class Work>
  void for_each_task(const Work& work) {
    parallel_for(static_cast<int>(gaits_.size()), threads_, [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      try {
        work(i);
      } catch (const InputError& error) {
        cannot_play(i, error.what());
      } catch (const MujocoError& error) {
        cannot_play(i, error.what());
      }
    });
  }
  /// There is no such robot: that never passes.
  void cannot_play(std::size_t i, const char* why) {
    gaits_[i].reset();
    trials_[i] = {};
    trials_[i].distance = std::numeric_limits<double>::infinity();
    trials_[i].line = trials_[i].brief = why;
  }

  int threads_;
  std::vector<std::unique_ptr<GaitOnTrial>> gaits_;
  std::vector<GaitTrial> trials_;
};

PlayedCandidate played_tasks(std::vector<GaitTrial> trials) {
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
    const std::function<bool()>& stop) {
  std::vector<std::optional<PlayedCandidate>> out(designs.size());
  parallel_for(static_cast<int>(designs.size()), threads, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    if (!designs[i] || (stop && stop())) return;
    Candidate beside = candidate;
    beside.design = *designs[i];
    try {
      CandidateOnTrial on_trial(problem, beside, 1, stop);
      on_trial.glance();
      out[i] = played_tasks(on_trial.trials());
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
