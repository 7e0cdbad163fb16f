// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>

#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/cost_function.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {

/// An outer objective J = weight · v/v₀ with v(s, m) in physical units, that of an outer term. F is
/// of order one where a body does its task well; v₀ makes J so, too: weight 1 trades a share of v₀
/// for as much of F. v₀ follows from robot and task alone, so that J is the same for every start:
///   printed volume  that of the given body
///   mechanical work  that of the first guess of the given body's motion
///   peak torque  half the weight at the end of a level leg; the first guess has jerks
class OuterObjective {
 public:
  /// @param quantity F of one term alone, at weight 1. @param term its name, of role outer.
  /// Throws std::invalid_argument where the given body has none of the quantity.
  OuterObjective(Objective quantity, std::string_view term, double weight);

  const Objective& quantity() const { return quantity_; }
  std::string_view unit() const { return entry_->unit; }
  double weight() const { return weight_; }
  double reference() const { return reference_; }  // v₀ [unit()]

  /// v of the term's value, and J of v.
  double amount(double value) const;
  double cost(double amount) const { return weight_ * amount / reference_; }
  double amount_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const;
  int norm() const { return entry_->norm; }

 private:
  Objective quantity_;
  const TermEntry* entry_;
  double size_;  // of the term's residual [unit()]
  double weight_, reference_ = 1.0;
};

/// J with its gradients; it has no second derivatives. Keeps a reference.
class OuterCost final : public CostFunction {
 public:
  explicit OuterCost(const OuterObjective& outer);
  ~OuterCost() override;
  /// @param order up to Order::gradients
  void evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                Evaluation& out) override;
  const Eigen::VectorXd& motion_units() const override;

 private:
  const OuterObjective& outer_;
  std::unique_ptr<Objective::Workspace> workspace_;
};

}  // namespace legwright
