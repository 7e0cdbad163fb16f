// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/outer_cost.hpp"

#include <cmath>
#include <stdexcept>

namespace legwright {
namespace {

/// J of a term. Keeps a reference.
class TermCost final : public CostFunction {
 public:
  explicit TermCost(const OuterTerm& outer)
      : outer_(outer), workspace_(outer.quantity().make_workspace()) {}

  /// @param order up to Order::gradients
  void evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                Evaluation& out) override {
    outer_.quantity().evaluate(s, m, order, *workspace_, out);
    const double sum = out.value;
    out.value = outer_.cost(outer_.amount(sum));
    if (order == Order::value) return;
    const double slope = sum > 0.0 ? out.value / (outer_.norm() * sum) : 0.0;  // dJ by the sum
    out.stationarity *= slope;
    if (order == Order::gradients) out.partial_s *= slope;
  }
  const Eigen::VectorXd& motion_units() const override { return outer_.quantity().motion_units(); }

 private:
  const OuterTerm& outer_;
  std::unique_ptr<Objective::Workspace> workspace_;
};

}  // namespace

OuterTerm::OuterTerm(Objective quantity, std::string_view term, double weight)
    : OuterObjective(std::string(find_term(term)->unit), weight),
      quantity_(std::move(quantity)),
      entry_(find_term(term)),
      size_(quantity_.unit_of(term).size) {
  const Eigen::VectorXd s = quantity_.space().initial();
  const double reference =
      entry_->norm > 1 ? 0.5 * size_ : amount_at(s, initial_guess(quantity_, s));
  if (!(reference > 0.0) || !std::isfinite(reference))
    throw std::invalid_argument("this robot has no " + std::string(entry_->cost_label) +
                                " that could be lowered");
  set_reference(reference);
}

double OuterTerm::amount(double value) const { return size_ * std::pow(value, 1.0 / norm()); }

double OuterTerm::amount_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const {
  return amount(quantity_.evaluate(s, m, Order::value).value);
}

std::unique_ptr<CostFunction> OuterTerm::make_cost() const {
  return std::make_unique<TermCost>(*this);
}

}  // namespace legwright
