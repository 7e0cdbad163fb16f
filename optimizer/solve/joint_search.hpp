// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/solve/codesign.hpp"
#include "optimizer/solve/joint_newton.hpp"

namespace legwright {

/// joint_newton() from where a co-design run stands after iteration 0, at the limits of its
/// options: from each task's first motions, and from those on the way of iteration 0 where there
/// are any. @param s design of iteration 0
[[nodiscard]] JointNewtonResult joint_search(const TaskSolvers& solvers, const DesignBox& box,
                                             const Eigen::VectorXd& s,
                                             const CodesignOptions& options);

}  // namespace legwright
