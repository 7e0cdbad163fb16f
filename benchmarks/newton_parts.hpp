// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "benchmarks/timing.hpp"
#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/newton.hpp"

namespace legwright::bench {

/// Everything of Newton's method that is timed at one point (s, m*) of one task. Keeps references.
class NewtonParts {
 public:
  NewtonParts(const Objective& objective, const Eigen::VectorXd& s, const Eigen::VectorXd& m);

  void evaluate(Order order) {
    cost_.evaluate(s_, m_, order, order == Order::hessian ? at_ : trial_);
  }
  void factor_and_solve();
  /// F, G and H, factor, solve, and F with G at the trial point.
  void iteration();
  void solve_from_standing();

  const SolveReport& report() const { return report_; }  // of the last solve

 private:
  const Objective& objective_;
  ObjectiveCost cost_;
  const Eigen::VectorXd& s_;
  const Eigen::VectorXd& m_;
  Evaluation at_, trial_;
  HessianFactor factor_;
  Eigen::VectorXd step_;
  NewtonWorkspace workspace_;
  SolveReport report_;
};

/// Who competes, in this order.
enum NewtonContestant { kFloor, kGradient, kHessian, kIteration, kSolve };

/// factor + solve, F + gradient, F + gradient + Hessian, a Newton iteration, a motion solve.
std::vector<Contestant> contestants(NewtonParts& parts);

}  // namespace legwright::bench
