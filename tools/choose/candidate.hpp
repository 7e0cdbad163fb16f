// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/codesign.hpp"
#include "tools/choose/planned_objective.hpp"
#include "tools/choose/tightening.hpp"
#include "tools/run/played_gait.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// A body with its motions that a search came by. All tasks of the problem, in their order.
struct Candidate {
  // "optimum", "initial", "iteration 7", "from pace", "tightened: larger margins"; where that does
  // not set out from the optimum "initial, tightened motion: larger margins".
  std::string name;
  DesignIteration design;
  // Of each task in the search that found it, and F as that search had it; or empty: as asked.
  std::vector<Tightening> tightening = {};
  std::vector<std::shared_ptr<const PlannedObjective>> planned = {};

  /// F whose plan the motion of task k is. The problem outlives it.
  std::shared_ptr<const Objective> objective(const CodesignProblem& problem, int k) const;
  /// The task of that F.
  const Task& planned_task(const CodesignProblem& problem, int k) const;
};

/// What physics says of a candidate in all tasks together.
struct PlayedCandidate {
  bool pass = false;
  double distance = 0.0;   // from passing, sum over tasks; infinite where one cannot be played
  bool to_the_end = true;  // false: it fails, by at least this distance, and was played no further
  std::string line;        // of the tasks that fail, or of all
  std::vector<GaitTrial> trials = {};  // of each task

  /// For run.json. @param task of which alone it is told; nothing: of all together
  PlayedGait record(std::optional<int> task = {}) const;
};

/// For how long a candidate is played. Until failure: all its tasks for their first cycles; where
/// they pass, for all cycles; where they pass these, with other numerics. Whole: all cycles at
/// once, and other numerics for each task that passes. Distances are of what was played: what comes
/// through its first cycles may have more than what does not.
enum class PlayLength { until_failure, whole };

/// Plays every task of a candidate at half, default and double gains. Needs load_gait_plugin().
/// Throws RolloutStopped where `stop` says so.
PlayedCandidate play_candidate(const CodesignProblem& problem, const Candidate& candidate,
                               int threads, PlayLength length = PlayLength::until_failure,
                               const std::function<bool()>& stop = {});

/// The largest Floquet multiplier of its gaits at these gains: below 1 each comes back to its cycle
/// by itself after a small disturbance. Infinite where one falls or cannot be played. Throws
/// RolloutStopped where `stop` says so.
double largest_multiplier(const CodesignProblem& problem, const Candidate& candidate, int threads,
                          const std::function<bool()>& stop = {});

/// Glances at designs of the candidate's own search in MuJoCo, each where there is one.
std::vector<std::optional<PlayedCandidate>> play_beside(
    const CodesignProblem& problem, const Candidate& candidate,
    const std::vector<std::optional<DesignIteration>>& designs, int threads,
    const std::function<bool()>& stop, const Checkpoint& checkpoint = {});

/// Sets F, J and their terms to those of the tasks as they were given, for a candidate that was
/// found with tightened ones; but for the speed and turn that it was aimed at.
void evaluate_as_asked(const CodesignProblem& problem, Candidate& candidate);

/// Sets F and its terms to those of the candidate's own search. @param design a copy of its design
void evaluate_as_planned(const CodesignProblem& problem, const Candidate& candidate,
                         DesignIteration& design);

}  // namespace legwright
