// SPDX-License-Identifier: Apache-2.0
#include "tools/run/design_json.hpp"

namespace legwright {

Json by_name(const DesignSpace& space, const Eigen::VectorXd& values) {
  Json object = Json::object();
  for (int k = 0; k < space.size(); ++k) object[space.parameters[k].name] = values(k);
  return object;
}

}  // namespace legwright
