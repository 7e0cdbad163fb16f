// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/design.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// {"name": value, …} for a vector in the order of the design's parameters.
Json by_name(const DesignSpace& space, const Eigen::VectorXd& values);

}  // namespace legwright
