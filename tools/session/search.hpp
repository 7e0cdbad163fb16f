// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "optimizer/solve/joint_newton.hpp"
#include "optimizer/solve/multistart.hpp"
#include "optimizer/solve/status.hpp"

namespace legwright {

/// How a session searches on from where it stands.
struct SearchRules {
  int most = 0;     // points after which it ends; 0: by itself
  int threads = 1;  // at most one per task is of use; results do not depend on it
  std::function<bool()> stop = [] { return false; };  // asked before each Newton iteration
  /// Called with each point, in order. Motions of most are on their way to m*(s).
  std::function<void(const JointPoint&)> tell = [](const JointPoint&) {};
};

struct SearchEnd {
  int points = 0;                                     // that were told
  SolveStatus status = SolveStatus::iteration_limit;  // `stopped`: by `stop` or `most`
};

/// min Σ wᵢ Fᵢ + Jᵢ over body and motions from the body and the motions at hand: by joint_newton()
/// without J, then by Algorithm 1 with it. After so many points it is where it was after them in
/// a search that went on: so a search can be told by their number. Deterministic.
/// @param tasks their weights and initial motions are what counts
[[nodiscard]] SearchEnd search_on(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                                  const Eigen::VectorXd& s, const SearchRules& rules);

/// One iteration of Algorithm 1: another body with its motions m*(s). @return the point, without a
/// motion where `stop` said so or there is no better body
[[nodiscard]] JointPoint step_on(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                                 const Eigen::VectorXd& s, const SearchRules& rules);

}  // namespace legwright
