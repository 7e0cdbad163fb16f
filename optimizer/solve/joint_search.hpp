// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/solve/codesign.hpp"
#include "optimizer/solve/joint_newton.hpp"

namespace legwright {

/// joint_newton() from where a co-design run stands after iteration 0, at the limits of its
/// options: from each task's first motions, and from those on the way of iteration 0 where there
/// are any. @param s design of iteration 0
[[nodiscard]] JointNewtonResult joint_search(const TaskSolvers& solvers, const DesignBox& box,
                                             const Eigen::VectorXd& s,
                                             const CodesignOptions& options);

/// The points of a joint search that are iterates of a run that stood at design s with this F: the
/// last `most` of those that have less F and another design.
[[nodiscard]] std::vector<JointPoint> last_points(const JointNewtonResult& found, double value,
                                                  const Eigen::VectorXd& s, int most);

}  // namespace legwright
