// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tools/choose/candidate.hpp"

namespace legwright {

/// A candidate whose turn comes.
struct CandidateInTurn {
  const Candidate* design = nullptr;
  /// One that failed and is much like it: where that failed worst it is played first. Or null.
  const PlayedCandidate* like = nullptr;
};

struct PlayedInTurn {
  std::vector<PlayedCandidate> played;  // of the candidates from the first on
  bool stopped = false;                 // those that are missing have not been played
};

/// Plays candidates until each fails, task by task and gain by gain, up to the first that passes.
/// Where none passes, those that failed are played on, the nearest to passing as far as is known
/// first, until it is certain which `nearest` of them are the nearest: these are played to the end
/// of their first cycles, and no other can be as near. So who is nearest, and how near, is what
/// play_candidate() says, at the price of fewer roll-outs. Results do not depend on the number of
/// threads. Needs load_gait_plugin().
PlayedInTurn play_in_turn(const CodesignProblem& problem,
                          const std::vector<CandidateInTurn>& candidates, std::size_t nearest,
                          int threads, const std::function<bool()>& stop);

}  // namespace legwright
