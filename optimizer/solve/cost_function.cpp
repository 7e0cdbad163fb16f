// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/cost_function.hpp"

namespace legwright {

ObjectiveCost::ObjectiveCost(const Objective& objective)
    : objective_(objective), workspace_(objective.make_workspace()) {}

ObjectiveCost::~ObjectiveCost() = default;

void ObjectiveCost::evaluate(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
                             Evaluation& out) {
  objective_.evaluate(s, m, order, *workspace_, out);
}

const Eigen::VectorXd& ObjectiveCost::motion_units() const { return objective_.motion_units(); }

std::vector<std::string_view> ObjectiveCost::term_names() const { return objective_.term_names(); }

}  // namespace legwright
