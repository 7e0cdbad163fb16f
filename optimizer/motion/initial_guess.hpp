// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/gait.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"

namespace legwright {

/// m₀: standing in the nominal pose, sliding along at the wanted speed, weight shared by the stance feet.
Eigen::VectorXd initial_guess(const Morphology& morphology, const Layout& layout, const Gait& gait,
                              const WantedPath& path, const Eigen::VectorXd& s);

}  // namespace legwright
