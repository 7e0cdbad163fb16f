// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "optimizer/solve/reduced_step.hpp"
#include "optimizer/solve/status.hpp"
#include "optimizer/solve/task_solver.hpp"

namespace legwright {

/// A point (s, m₁ … m_k) of the search.
struct JointPoint {
  Eigen::VectorXd s;
  std::vector<Eigen::VectorXd> motions;
  double value = 0.0;  // Σ wᵢ Fᵢ
};

/// Knobs of a search over body and motions at once. Motions are measured in motion_units(), the
/// design in DesignSpace::scale().
struct JointNewtonOptions {
  int max_iterations = 150;
  int scout_iterations = 20;       // of each start where there are several; the lowest goes on
  double motion_tolerance = 1e-4;  // on max |G·unit|
  double design_tolerance = 1e-4;  // on the projected gradient
  // F not falling by this share over so many iterations: `stalled`.
  int stagnation_window = 12;
  double stagnation_decrease = 1e-5;
  double first_trust = 0.1, largest_trust = 0.3;  // largest change of a parameter in one step
  // A point of the path is told where a parameter has moved by this much since the one before.
  double told_change = 0.3;
  int threads = 1;                   // at most one per task is of use; results do not depend on it
  std::function<bool()> go_on = {};  // asked before every iteration; false: `stopped`
  /// Called after each step, of each start, with the point that it came to.
  std::function<void(const JointPoint&)> on_step = {};
  /// Of this search, as NewtonOptions::checkpoint.
  Checkpoint checkpoint = {};
};

struct JointNewtonResult {
  SolveStatus status = SolveStatus::iteration_limit;
  std::vector<JointPoint> path;  // points that are told, and the best; empty: F is not finite
  int iterations = 0, factorisations = 0, evaluations = 0;  // of all starts

  const JointPoint& best() const { return path.back(); }
};

/// min Σ wᵢ Fᵢ(s, mᵢ) over body and motions at once, within the bounds of s, instead of eq (3)'s
/// way by m*(s). Newton's step of all unknowns by the Schur complement onto s: with Hᵢ = ∂Gᵢ/∂mᵢ,
/// Bᵢ = ∂Gᵢ/∂s, Xᵢ = Hᵢ⁻¹Bᵢ, yᵢ = Hᵢ⁻¹Gᵢ
///   (Σ wᵢ (∂²Fᵢ/∂s² − BᵢᵀXᵢ)) Δs = −Σ wᵢ (∂Fᵢ/∂s − Bᵢᵀyᵢ),  Δmᵢ = −yᵢ − Xᵢ Δs,
/// Hᵢ shifted until it is positive and as far as steps succeed, Δs within a trust region. Steps are
/// bent by CostFunction::correct_step() and corrected with the same factors. A motion need not be
/// at its minimum before the body moves, so a body that cannot do the task costs no hopeless solve.
/// `converged`: both gradients below tolerance with exact Hᵢ; the outer objectives Jᵢ do not count.
/// Deterministic. @param start design, within bounds. @param motions starts, each with a motion for
/// every task; initial_motion of the tasks does not count
[[nodiscard]] JointNewtonResult joint_newton(
    const std::vector<WeightedCost>& tasks, const DesignBox& box, const Eigen::VectorXd& start,
    const std::vector<std::vector<Eigen::VectorXd>>& motions,
    const JointNewtonOptions& options = {});

}  // namespace legwright
