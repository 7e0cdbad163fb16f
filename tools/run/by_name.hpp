// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/design.hpp"
#include "optimizer/solve/codesign.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// A vector by the names of the design's parameters.
ByName<double> by_name(const DesignSpace& space, const Eigen::VectorXd& values);
/// The terms of F of a task, by name.
ByName<double> by_term(const TaskIterate& iterate);

}  // namespace legwright
