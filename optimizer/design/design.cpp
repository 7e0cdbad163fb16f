// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/design.hpp"

namespace legwright {
namespace {

template <class Pick>
Eigen::VectorXd gather(const DesignSpace& space, Pick pick) {
  Eigen::VectorXd values(space.size());
  for (int k = 0; k < space.size(); ++k) values[k] = pick(space.parameters[k]);
  return values;
}

}  // namespace

Eigen::VectorXd DesignSpace::initial() const {
  return gather(*this, [](const DesignParameter& p) { return p.initial; });
}

Eigen::VectorXd DesignSpace::lower() const {
  return gather(*this, [](const DesignParameter& p) { return p.lower; });
}

Eigen::VectorXd DesignSpace::upper() const {
  return gather(*this, [](const DesignParameter& p) { return p.upper; });
}

Eigen::VectorXd DesignSpace::clamp(const Eigen::VectorXd& s) const {
  return s.cwiseMax(lower()).cwiseMin(upper());
}

Eigen::VectorXd DesignSpace::scale() const {
  return gather(*this, [](const DesignParameter& p) {
    return p.kind == ParameterKind::length ? p.initial : 1.0;
  });
}

}  // namespace legwright
