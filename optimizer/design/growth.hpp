// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// The amount that a sum over point masses counts.
enum class Amount { mass, printed_volume };

/// A sum over all point masses that depends on the design alone, Σ amount · Π s_k/l_k, with exact
/// derivatives.
struct GrowthSum {
  double value = 0.0;        // kg or m³
  Eigen::VectorXd gradient;  // in the order of `parameters`
  Eigen::MatrixXd hessian;
};

/// Parameters that the masses depend on, rising.
std::vector<int> growth_parameters(const Morphology& morphology);
GrowthSum growth_sum(const Morphology& morphology, Amount amount, const Eigen::VectorXd& s);

}  // namespace legwright
