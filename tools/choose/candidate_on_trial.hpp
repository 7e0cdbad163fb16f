// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "tools/choose/candidate.hpp"
#include "tools/choose/physics_trial.hpp"

namespace legwright {

/// The gaits of a candidate, one for each task, and what MuJoCo said of them last. A gait that
/// cannot be played at all never passes. Throws RolloutStopped where `stop` says so.
class CandidateOnTrial {
 public:
  /// Keeps references to the problem and the candidate.
  CandidateOnTrial(const CodesignProblem& problem, const Candidate& candidate, int threads,
                   std::function<bool()> stop);

  /// @return whether all tasks pass
  bool play(PlayedCycles cycles);
  /// Of each task that passes.
  void ask_other_numerics();
  void glance();
  double largest_multiplier();
  /// GaitOnTrial::play_first() of a task; nothing where it cannot be played.
  std::optional<FirstCycles> play_first(std::size_t task, std::size_t gain, bool goes_on);
  /// What such plays of a task say together.
  GaitTrial trial_of_first(std::size_t task, const std::vector<FirstCycles>& runs) const;

  const std::vector<GaitTrial>& trials() const { return trials_; }

 private:
  struct Gait {
    std::unique_ptr<GaitOnTrial> on_trial;  // null: not yet, or it cannot be played
    bool broken = false;
  };
  int threads_of_gait() const;
  void for_each_gait(const std::function<void(GaitOnTrial&, GaitTrial&)>& work);
  bool with_gait(std::size_t task, const std::function<void(GaitOnTrial&)>& work);

  const CodesignProblem& problem_;
  const Candidate& candidate_;
  int threads_;
  std::function<bool()> stop_;
  std::vector<Gait> gaits_;
  std::vector<GaitTrial> trials_;
};

/// What trials of all tasks say together.
PlayedCandidate played_tasks(std::vector<GaitTrial> trials);

}  // namespace legwright
