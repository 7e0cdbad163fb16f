// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/objective/objective.hpp"

namespace legwright {

/// m₀: standing in the nominal pose, sliding along at the wanted speed, weight shared by the stance feet.
Eigen::VectorXd initial_guess(const Objective& objective, const Eigen::VectorXd& s);

}  // namespace legwright
