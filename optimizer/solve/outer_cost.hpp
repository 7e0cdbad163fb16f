// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/cost_function.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {

/// An outer objective J = weight · v/v₀ of a quantity v(s, m) in physical units. F is of order one
/// where a body does its task well; v₀ makes J so, too: weight 1 trades a share of v₀ for as much
/// of F. v₀ follows from robot and task alone, so that J is the same for every start.
class OuterObjective {
 public:
  virtual ~OuterObjective() = default;

  std::string_view unit() const { return unit_; }
  double weight() const { return weight_; }
  double reference() const { return reference_; }  // v₀ [unit()]
  double cost(double amount) const { return weight_ * amount / reference_; }

  /// v at (s, m).
  virtual double amount_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const = 0;
  /// J with its gradients, for one thread at a time; it has no second derivatives, and refers to
  /// this.
  virtual std::unique_ptr<CostFunction> make_cost() const = 0;

 protected:
  OuterObjective(std::string unit, double weight) : unit_(std::move(unit)), weight_(weight) {}
  OuterObjective(const OuterObjective&) = default;
  OuterObjective(OuterObjective&&) = default;
  OuterObjective& operator=(const OuterObjective&) = default;
  OuterObjective& operator=(OuterObjective&&) = default;
  void set_reference(double amount) { reference_ = amount; }

 private:
  std::string unit_;
  double weight_, reference_ = 1.0;
};

/// That of an outer term. v₀ is
///   printed volume  that of the given body
///   mechanical work  that of the first guess of the given body's motion
///   peak torque  half the weight at the end of a level leg; the first guess has jerks
class OuterTerm final : public OuterObjective {
 public:
  /// @param quantity F of one term alone, at weight 1. @param term its name, of role outer.
  /// Throws std::invalid_argument where the given body has none of the quantity.
  OuterTerm(Objective quantity, std::string_view term, double weight);

  const Objective& quantity() const { return quantity_; }
  /// v of the term's value.
  double amount(double value) const;
  int norm() const { return entry_->norm; }

  double amount_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const override;
  std::unique_ptr<CostFunction> make_cost() const override;

 private:
  Objective quantity_;
  const TermEntry* entry_;
  double size_;  // of the term's residual [unit()]
};

}  // namespace legwright
