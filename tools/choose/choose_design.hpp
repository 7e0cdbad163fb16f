// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/choose/candidate.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

struct ChoiceOptions {
  CodesignOptions codesign;  // of searches with tightened tasks
  int threads = 1;           // of searches and roll-outs; results do not depend on it
  /// Of searches with tightened tasks, where fewer parameters may change than those of the problem:
  /// then no other designs of the search are candidates either.
  std::optional<DesignSpace> space = {};
  std::function<void(const std::string&)> tell = {};  // one line per candidate
  std::function<bool()> stop = {};
};

/// What a run hands back, and why.
struct ChosenDesign {
  Candidate result;
  ChoiceRecord record;
  /// The result and what else is worth a look, each with its place in record.candidates: the
  /// optimum, and all that pass.
  std::vector<std::pair<std::size_t, Candidate>> kept;
};

/// Of the designs that a search came by the one with the least F that MuJoCo passes at half,
/// default and double gains; where it passes none, the one nearest to passing. The optimum is
/// played first, and is the result where it passes. Else the given body is played, and the search
/// goes on from the optimum with tightened tasks: of the motion alone, then in rounds of body and
/// motion, each of which pulls every lever once and goes on from what brings physics nearest to
/// passing. Where none passes, or with more F than the given body has, the motion of that body is
/// tightened, too; where still none does, the search goes on from another start's optimum that has
/// up to 1.3 times the F. Iterates on the way and the optima of other starts are played as well.
/// Designs are played by rising F, and none whose F is above that of one that passes. So the result
/// never fails where the given body passes. Where several pass within a tenth of the least F, the
/// cheapest with a stable cycle (largest_multiplier() below 1) is the result, if there is one.
/// Stopped, it hands back the best of those that were played, or throws RolloutStopped.
/// @param tasks costs of the problem. @param along the iterates of all starts, those of the whole
/// problem. Throws MujocoError.
ChosenDesign choose_design(const CodesignProblem& problem, const std::vector<JointTask>& tasks,
                           const MultistartResult& found, const std::vector<DesignIteration>& along,
                           const ChoiceOptions& options);

}  // namespace legwright
