// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/cost_function.hpp"

namespace legwright {

void CostFunction::set_step_base(const Eigen::VectorXd&, const Eigen::VectorXd&) {}

void CostFunction::correct_step(const Eigen::VectorXd&, Eigen::VectorXd&) {}

ObjectiveCost::ObjectiveCost(const Objective& objective)
    : objective_(objective),
      workspace_(objective.make_workspace()),
      poses_(objective.morphology(), objective.layout(), objective.motion_units()) {}

ObjectiveCost::~ObjectiveCost() = default;

void ObjectiveCost::evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                             Evaluation& out) {
  objective_.evaluate(s, m, order, *workspace_, out);
}

void ObjectiveCost::set_step_base(const Eigen::VectorXd& s, const Eigen::VectorXd& m) {
  poses_.set_base(s, m);
}

void ObjectiveCost::correct_step(const Eigen::VectorXd& s, Eigen::VectorXd& m) {
  poses_.correct(s, m);
}

const Eigen::VectorXd& ObjectiveCost::motion_units() const { return objective_.motion_units(); }

std::vector<std::string_view> ObjectiveCost::term_names() const { return objective_.term_names(); }

std::vector<TermValue> named_terms(const CostFunction& cost, const Evaluation& at) {
  std::vector<TermValue> terms;
  const std::vector<std::string_view> names = cost.term_names();
  for (std::size_t k = 0; k < names.size() && k < at.term_values.size(); ++k)
    terms.push_back({names[k], at.term_values[k]});
  return terms;
}

}  // namespace legwright
