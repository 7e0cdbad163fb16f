// SPDX-License-Identifier: Apache-2.0
#include "tools/session/state.hpp"

namespace legwright {

double SessionState::value() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * now->tasks[k].value;
  return sum;
}

double SessionState::outer_value() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * now->tasks[k].outer_value;
  return sum;
}

Eigen::VectorXd SessionState::design_gradient() const {
  if (!settled()) return {};
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(s().size());
  for (std::size_t k = 0; k < weights.size(); ++k)
    sum += weights[k] * now->tasks[k].design_gradient;
  return sum;
}

DesignSpace SessionState::space() const {
  DesignSpace out = problem->robot.space;
  for (int i = 0; i < out.size(); ++i) {
    DesignParameter& parameter = out.parameters[i];
    parameter.lower = frozen[i] ? s()[i] : lower[i];
    parameter.upper = frozen[i] ? s()[i] : upper[i];
  }
  return out;
}

bool same_layout(const Objective& a, const Objective& b) {
  const Layout &x = a.layout(), &y = b.layout();
  if (x.motion_size() != y.motion_size() || x.knot_count() != y.knot_count() ||
      x.foot_count() != y.foot_count())
    return false;
  for (int knot = 0; knot <= x.knot_count(); ++knot)
    for (int foot = 0; foot < x.foot_count(); ++foot)
      if (x.force(knot, foot) != y.force(knot, foot)) return false;
  return true;
}

}  // namespace legwright
