// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace legwright {

/// What physics says of a gait that was planned with certain scalars.
struct PhysicsTrial {
  /// How far each measured quantity is from what the task wants, in its tolerance; the same
  /// quantities in every trial. Empty: there is no such gait.
  Eigen::VectorXd residual;
  bool pass = false;  // the verdict
  std::string line;   // for people

  /// ½‖residual‖²; infinite where there is none or it is not finite.
  double merit() const;
};

/// One trust-region step: where it went, and what came of it.
struct PhysicsStep {
  Eigen::VectorXd x;
  double radius = 0.0;           // of the trust region
  double predicted_merit = 0.0;  // by the linear model of the residual
  PhysicsTrial trial;
  bool accepted = false;
};

struct PhysicsStepOptions {
  int steps = 5;                                       // at most
  double radius = 1.0, smallest = 0.1, largest = 4.0;  // of the trust region, in units of x
  double probe = 0.5;  // offset of the finite differences: roll-outs are rough functions
  double gain = 1e-3;  // relative decrease of the merit that is none
  int threads = 1;     // of the probes; results do not depend on it
  std::function<void(const PhysicsStep&)> on_step = {};
  std::function<bool()> stop = {};  // asked before each step
};

struct PhysicsStepsResult {
  Eigen::VectorXd x;   // best that physics confirmed
  PhysicsTrial start;  // at the x that was given
  PhysicsTrial best;   // at `x`
  std::vector<PhysicsStep> steps;
  int trials = 0;  // gaits that were planned and played
};

/// Minimises ½‖r(x)‖² of roll-outs over a few scalars by trust-region Gauss–Newton steps: r by
/// finite differences, then by Broyden's updates; box-shaped trust region. A step counts only if
/// the roll-out at its end has a smaller merit and does not lose a verdict that passed; so the
/// result is never worse than the start.
/// @param play plans and plays a gait; called from several threads. @param lower,upper bounds of x.
PhysicsStepsResult take_physics_steps(
    const std::function<PhysicsTrial(const Eigen::VectorXd&)>& play, const Eigen::VectorXd& start,
    const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, const PhysicsStepOptions& options);

}  // namespace legwright
