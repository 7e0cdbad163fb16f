// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "optimizer/solve/checkpoint.hpp"
#include "tools/choose/candidate.hpp"
#include "tools/choose/physics_trial.hpp"

namespace legwright {

void pass_state(SolveState& state, double& multiplier);
void pass_state(SolveState& state, GaitTrial& trial);
void pass_state(SolveState& state, PlayedCandidate& played);
void pass_state(SolveState& state, std::vector<PlayedCandidate>& played);

/// What a play finds, or what it found before the process that made it was killed. Nothing is kept
/// and nothing found once a run was asked to stop.
template <class Play>
auto kept_play(Checkpoint checkpoint, const std::function<bool()>& stop, const Play& play) {
  if (stop && stop()) return play();  // of other candidates than a whole run has here
  decltype(play()) out{};
  const auto pass = [&out](SolveState& state) { pass_state(state, out); };
  if (checkpoint.take_up(pass)) return out;
  out = play();
  if (!stop || !stop()) checkpoint.keep(pass);
  return out;
}

}  // namespace legwright
