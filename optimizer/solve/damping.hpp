// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "optimizer/solve/newton.hpp"

namespace legwright {

/// The shift σ of (H + σ diag(1/unit²)) p = −G by the rules of NewtonOptions, remembered from step
/// to step.
class Damping {
 public:
  /// Keeps a reference to the rules.
  explicit Damping(const NewtonOptions& rules) : rules_(rules), shift_(rules.initial_shift) {}

  double shift() const { return shift_; }
  Eigen::VectorXd diagonal(const Eigen::VectorXd& units) const {
    return shift_ * units.cwiseAbs2().cwiseInverse();
  }
  /// After a factor that is not positive or a step that cannot be kept: faster from the third
  /// failure in turn on, for twelve tries must reach any curvature that F may have.
  void grow(int failures = 0) {
    const double g = rules_.shift_growth;
    shift_ = std::max(shift_ * (failures < 2 ? g : g * g), rules_.seed_shift);
  }
  /// After a full step whose decrease was as promised.
  void decay() {
    shift_ *= rules_.shift_decay;
    if (shift_ < rules_.least_shift) shift_ = 0.0;
  }
  void drop() { shift_ = 0.0; }
  void pass_state(SolveState& state) { state(shift_); }

 private:
  const NewtonOptions& rules_;
  double shift_;
};

}  // namespace legwright
