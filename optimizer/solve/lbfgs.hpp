// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

namespace legwright {

/// Limited-memory BFGS within bounds (Liu and Nocedal's two-loop recursion on the parameters that
/// are free). Works on s divided by the parameters' natural units, so that metres and radians count
/// alike. Deterministic.
class Lbfgs {
 public:
  /// @param scale natural unit of each parameter, positive. @param history pairs kept.
  Lbfgs(Eigen::VectorXd scale, int history);

  /// Forgets all pairs: the next direction is the steepest descent.
  void reset() { pairs_.clear(); }
  int pair_count() const { return static_cast<int>(pairs_.size()); }

  /// Takes a step and the change of gradient along it; returns false and leaves the pair out where
  /// the curvature is not clearly positive or a number is not finite.
  bool add(const Eigen::VectorXd& step, const Eigen::VectorXd& gradient_change);

  /// −B⁻¹g on the free parameters, 0 on the others; a direction of descent, or zero where the
  /// gradient is.
  Eigen::VectorXd direction(const Eigen::VectorXd& gradient, const std::vector<bool>& free) const;

 private:
  struct Pair {
    Eigen::VectorXd step, change;  // of s/scale and gradient·scale
  };
  Eigen::VectorXd scale_;
  int history_;
  std::deque<Pair> pairs_;
};

/// Parameters that may move: not at a bound that the gradient pushes against.
std::vector<bool> free_parameters(const Eigen::VectorXd& s, const Eigen::VectorXd& gradient,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// Largest |gradient·scale| over the free parameters: zero at a minimum within bounds.
double projected_gradient_norm(const Eigen::VectorXd& s, const Eigen::VectorXd& gradient,
                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                               const Eigen::VectorXd& scale);

}  // namespace legwright
