// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/outer_cost.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace legwright {

OuterObjective::OuterObjective(Objective quantity, std::string_view term, double weight)
    : quantity_(std::move(quantity)),
      entry_(find_term(term)),
      size_(quantity_.unit_of(term).size),
      weight_(weight) {
  const Eigen::VectorXd s = quantity_.space().initial();
  reference_ = entry_->norm > 1 ? 0.5 * size_ : amount_at(s, initial_guess(quantity_, s));
  if (!(reference_ > 0.0) || !std::isfinite(reference_))
    throw std::invalid_argument("this robot has no " + std::string(entry_->cost_label) +
                                " that could be lowered");
}

double OuterObjective::amount(double value) const {
  return size_ * std::pow(value, 1.0 / entry_->norm);
}

double OuterObjective::amount_at(const Eigen::VectorXd& s, const Eigen::VectorXd& m) const {
  return amount(quantity_.evaluate(s, m, Order::value).value);
}

OuterCost::OuterCost(const OuterObjective& outer)
    : outer_(outer), workspace_(outer.quantity().make_workspace()) {}

OuterCost::~OuterCost() = default;

void OuterCost::evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                         Evaluation& out) {
  outer_.quantity().evaluate(s, m, order, *workspace_, out);
  const double sum = out.value;
  out.value = outer_.cost(outer_.amount(sum));
  if (order == Order::value) return;
  const double slope = sum > 0.0 ? out.value / (outer_.norm() * sum) : 0.0;  // dJ by the sum
  out.stationarity *= slope;
  if (order == Order::gradients) out.partial_s *= slope;
}

const Eigen::VectorXd& OuterCost::motion_units() const { return outer_.quantity().motion_units(); }

}  // namespace legwright
