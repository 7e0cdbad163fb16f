// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/growth.hpp"

#include <algorithm>
#include <set>

namespace legwright {

std::vector<int> growth_parameters(const Morphology& morphology) {
  std::set<int> parameters;
  for (const Link& link : morphology.links)
    for (const PointMass& point : link.masses)
      for (const PointMass::Growth& growth : point.growth) parameters.insert(growth.parameter);
  return {parameters.begin(), parameters.end()};
}

GrowthSum growth_sum(const Morphology& morphology, Amount amount, const Eigen::VectorXd& s) {
  const std::vector<int> parameters = growth_parameters(morphology);
  const auto column = [&](int parameter) {
    return static_cast<int>(std::lower_bound(parameters.begin(), parameters.end(), parameter) -
                            parameters.begin());
  };
  GrowthSum out;
  const auto size = static_cast<int>(parameters.size());
  out.gradient.setZero(size);
  out.hessian.setZero(size, size);
  for (const Link& link : morphology.links)
    for (const PointMass& point : link.masses) {
      const double value =
          (amount == Amount::mass ? point.mass : point.volume) * point.growth_at(s);
      out.value += value;
      for (std::size_t a = 0; a < point.growth.size(); ++a) {
        const int k = point.growth[a].parameter;
        out.gradient[column(k)] += value / s[k];
        for (std::size_t b = 0; b < point.growth.size(); ++b) {
          const int l = point.growth[b].parameter;
          if (a != b) out.hessian(column(k), column(l)) += value / (s[k] * s[l]);
        }
      }
    }
  return out;
}

}  // namespace legwright
