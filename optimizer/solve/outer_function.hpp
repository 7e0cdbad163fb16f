// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "optimizer/objective/motion_arrays.hpp"
#include "optimizer/solve/outer_cost.hpp"

namespace legwright {

/// v of body and motion, and where `gradient` is not null its derivative by each entry, all others
/// fixed. Called from several threads at once; a function of its arguments alone.
using MotionQuantity = std::function<double(const MotionArrays& at, MotionArrays* gradient)>;

/// The outer objective of a function of the arrays of a motion. Torques, mass and volume are
/// functions of s and m themselves; the chain rule through them is this class's part.
class OuterFunction final : public OuterObjective {
 public:
  /// @param objective F of robot and task, for their kinematics; must live longer.
  /// @param reference v₀; none: v of the first guess of the given body's motion.
  /// Throws std::invalid_argument where v₀ is not positive.
  OuterFunction(const Objective& objective, MotionQuantity function, std::string unit,
                double weight, std::optional<double> reference);

  double amount_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const override;
  std::unique_ptr<CostFunction> make_cost() const override;

 private:
  const Objective& objective_;
  MotionQuantity function_;
};

}  // namespace legwright
