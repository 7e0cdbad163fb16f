// SPDX-License-Identifier: Apache-2.0
#include "tools/run/by_name.hpp"

namespace legwright {

ByName<double> by_name(const DesignSpace& space, const Eigen::VectorXd& values) {
  ByName<double> out;
  for (int k = 0; k < space.size(); ++k) out.emplace_back(space.parameters[k].name, values(k));
  return out;
}

ByName<double> by_term(const TaskIterate& iterate) {
  ByName<double> out;
  for (const TermValue& term : iterate.terms) out.of(term.name) = term.value;
  return out;
}

}  // namespace legwright
