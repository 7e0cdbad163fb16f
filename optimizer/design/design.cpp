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

const char* to_string(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::length:
      return "length";
    case ParameterKind::axis_angle:
      return "axis_angle";
    case ParameterKind::position:
      return "position";
  }
  return "";
}

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
    if (p.kind == ParameterKind::length) return p.initial;
    if (p.kind == ParameterKind::position && !p.frozen()) return 0.5 * (p.upper - p.lower);
    return 1.0;
  });
}

int DesignSpace::find(std::string_view name) const {
  for (int k = 0; k < size(); ++k)
    if (parameters[k].name == name) return k;
  return -1;
}

}  // namespace legwright
