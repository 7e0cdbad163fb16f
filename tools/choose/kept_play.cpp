// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/kept_play.hpp"

namespace legwright {

void pass_state(SolveState& state, double& multiplier) { state(multiplier); }

void pass_state(SolveState& state, GaitTrial& trial) {
  state(trial.pass);
  state(trial.residual);
  state(trial.line);
  state(trial.distance);
  state(trial.speed_ratio);
  state(trial.heading_drift);
  state(trial.rollouts);
  state(trial.at_gains);
  state(trial.brief);
}

void pass_state(SolveState& state, PlayedCandidate& played) {
  state(played.pass);
  state(played.distance);
  state(played.to_the_end);
  state(played.line);
  state.size_of(played.trials);
  for (GaitTrial& trial : played.trials) pass_state(state, trial);
}

void pass_state(SolveState& state, std::vector<PlayedCandidate>& played) {
  state.size_of(played);
  for (PlayedCandidate& each : played) pass_state(state, each);
}

}  // namespace legwright
