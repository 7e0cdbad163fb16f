// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/candidate_on_trial.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "optimizer/base/parallel.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {

CandidateOnTrial::CandidateOnTrial(const CodesignProblem& problem, const Candidate& candidate,
                                   int threads, std::function<bool()> stop)
    : problem_(problem),
      candidate_(candidate),
      threads_(threads),
      stop_(std::move(stop)),
      gaits_(static_cast<std::size_t>(problem.task_count())),
      trials_(gaits_.size()) {}

int CandidateOnTrial::threads_of_gait() const {
  return std::max(1, threads_ / static_cast<int>(gaits_.size()));
}

// The gait of a task is made when it is first needed. @return false where it cannot be played
bool CandidateOnTrial::with_gait(std::size_t task, const std::function<void(GaitOnTrial&)>& work) {
  Gait& gait = gaits_[task];
  const auto cannot_play = [&](const char* why) {  // there is no such robot
    gait = {nullptr, true};
    trials_[task] = {};
    trials_[task].distance = std::numeric_limits<double>::infinity();
    trials_[task].line = trials_[task].brief = why;
  };
  try {
    if (!gait.on_trial && !gait.broken) {
      const auto k = static_cast<int>(task);
      const DesignIteration& design = candidate_.design;
      gait.on_trial = std::make_unique<GaitOnTrial>(
          problem_.robot, problem_.task(k),
          design_texts(problem_.robot, *candidate_.objective(problem_, k), design.s,
                       design.tasks.at(task).m),
          stop_);
    }
    if (!gait.broken) work(*gait.on_trial);
  } catch (const InputError& error) {
    cannot_play(error.what());
  } catch (const MujocoError& error) {
    cannot_play(error.what());
  }
  return !gait.broken;
}

void CandidateOnTrial::for_each_gait(const std::function<void(GaitOnTrial&, GaitTrial&)>& work) {
  parallel_for(static_cast<int>(gaits_.size()), threads_, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    with_gait(i, [&](GaitOnTrial& gait) { work(gait, trials_[i]); });
  });
}

bool CandidateOnTrial::play(PlayedCycles cycles) {
  for_each_gait([&](GaitOnTrial& gait, GaitTrial& trial) {
    const int before = trial.rollouts;
    trial = gait.play(cycles, threads_of_gait());
    trial.rollouts += before;
  });
  return std::all_of(trials_.begin(), trials_.end(),
                     [](const GaitTrial& trial) { return trial.pass; });
}

void CandidateOnTrial::ask_other_numerics() {
  for_each_gait([&](const GaitOnTrial& gait, GaitTrial& trial) {
    if (trial.pass) gait.ask_other_numerics(threads_of_gait(), trial);
  });
}

void CandidateOnTrial::glance() {
  for_each_gait([](const GaitOnTrial& gait, GaitTrial& trial) { trial = gait.glance(); });
}

double CandidateOnTrial::largest_multiplier() {
  double largest = 0.0;
  for (std::size_t i = 0; i < gaits_.size(); ++i) {
    const bool playable = with_gait(i, [&](const GaitOnTrial& gait) {
      largest = std::max(largest, gait.largest_multiplier(threads_));
    });
    if (!playable) return std::numeric_limits<double>::infinity();  // or given up when disturbed
  }
  return largest;
}

std::optional<FirstCycles> CandidateOnTrial::play_first(std::size_t task, std::size_t gain,
                                                        bool goes_on) {
  std::optional<FirstCycles> out;
  const bool playable = with_gait(task, [&](GaitOnTrial& gait) {
    out = gait.play_first(gain, goes_on);
    ++trials_[task].rollouts;
  });
  return playable ? out : std::nullopt;
}

GaitTrial CandidateOnTrial::trial_of_first(std::size_t task,
                                           const std::vector<FirstCycles>& runs) const {
  if (gaits_[task].broken) return trials_[task];
  GaitTrial trial;
  if (runs.empty()) {
    trial.pass = true;  // as far as is known
    return trial;
  }
  return gaits_[task].on_trial->trial_of_first(runs);
}

PlayedCandidate played_tasks(std::vector<GaitTrial> trials) {
  PlayedCandidate out;
  out.pass = true;
  for (const GaitTrial& trial : trials) {
    out.pass = out.pass && trial.pass;
    out.distance += trial.distance;
  }
  for (const GaitTrial& trial : trials)
    if (trial.pass == out.pass) out.line += (out.line.empty() ? "" : "; ") + trial.line;
  out.trials = std::move(trials);
  return out;
}

}  // namespace legwright
