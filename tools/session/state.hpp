// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "optimizer/solve/task_solver.hpp"
#include "tools/session/given_motions.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// A body with a motion for each task, and what is known of F there: its value and terms; where the
/// motions are m*(s) its gradient dF/ds, too.
struct DesignPoint {
  Eigen::VectorXd s;
  std::vector<TaskIterate> tasks;  // in the problem's order
};

/// What a session stands at: all that undo brings back. Never changed once it is made, so readers
/// may keep it.
struct SessionState {
  std::shared_ptr<const CodesignProblem> problem;
  std::shared_ptr<GivenMotions> given_motions;  // of that problem's initial body
  std::vector<double> weights;                  // wᵢ of each task
  Eigen::VectorXd given;                        // the body that all changes are told from
  Eigen::VectorXd lower, upper;                 // bounds of s, within the robot's
  std::vector<bool> frozen;                     // of each parameter: stays where it is
  std::vector<bool> cold;  // of each task: its motion is a first guess, nothing is solved yet
  std::shared_ptr<const DesignPoint> now;   // what is shown
  std::shared_ptr<const DesignPoint> base;  // the last with m*(s), from which motions are
                                            // predicted; null before the first
  int iterations = 0;                       // of searches, along the way to here

  /// Whether the motions shown are m*(s), as near as Newton's method comes.
  bool settled() const { return now == base; }
  const Eigen::VectorXd& s() const { return now->s; }
  /// Σ wᵢ Fᵢ, without J.
  double value() const;
  /// Σ wᵢ Jᵢ; 0 without an outer objective.
  double outer_value() const;
  /// Σ wᵢ d(Fᵢ + Jᵢ)/ds; empty where the motions are not settled.
  Eigen::VectorXd design_gradient() const;
  /// The problem's design space with the bounds of this state; frozen parameters have equal ones.
  DesignSpace space() const;
};

/// Whether motions of one objective are motions of the other: the same knots, feet and stances.
bool same_layout(const Objective& a, const Objective& b);

}  // namespace legwright
