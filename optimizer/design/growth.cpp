// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/growth.hpp"

#include <algorithm>
#include <set>

#include "optimizer/design/hull_moments.hpp"

namespace legwright {

std::vector<int> growth_parameters(const Morphology& morphology) {
  std::set<int> parameters;
  for (const Link& link : morphology.links) {
    for (const PointMass& point : link.masses)
      for (const PointMass::Growth& growth : point.growth) parameters.insert(growth.parameter);
    for (const HullPart& hull : link.hulls)
      for (const int parameter : hull_parameters(hull)) parameters.insert(parameter);
  }
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
  for (const Link& link : morphology.links) {
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
    for (const HullPart& hull : link.hulls) {
      const HullMoments at = hull_volume(hull, s);
      const double factor = amount == Amount::mass ? hull.density : 1.0;
      out.value += factor * at.moments(3, 3);
      for (std::size_t k = 0; k < at.parameters.size(); ++k) {
        out.gradient[column(at.parameters[k])] += factor * at.first[k](3, 3);
        for (std::size_t l = 0; l < at.parameters.size(); ++l)
          out.hessian(column(at.parameters[k]), column(at.parameters[l])) +=
              factor * at.second[k][l](3, 3);
      }
    }
  }
  return out;
}

}  // namespace legwright
