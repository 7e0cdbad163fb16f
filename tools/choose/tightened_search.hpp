// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/choose/candidate.hpp"
#include "tools/choose/tightening.hpp"

namespace legwright {

/// Searches on from a candidate with tightened tasks. Nothing where there is no such design.
/// @param tasks costs of the problem as it was asked; weights and outer objectives are theirs
std::optional<Candidate> search_tightened(const CodesignProblem& problem,
                                          const std::vector<JointTask>& tasks,
                                          const Candidate& from,
                                          const std::vector<Tightening>& tightening,
                                          const DesignSpace& space, const CodesignOptions& options);

/// The tightening of a candidate with one lever pulled once more, in the tasks that fail.
std::vector<Tightening> pulled(const Candidate& candidate, const PlayedCandidate& played,
                               Lever lever);

/// Whether all tasks have the same levers pulled as often.
bool alike(const std::vector<Tightening>& a, const std::vector<Tightening>& b);

std::vector<Lever> all_levers();

}  // namespace legwright
