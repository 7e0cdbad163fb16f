// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/joint_search.hpp"

#include <utility>

namespace legwright {

using Eigen::VectorXd;

JointNewtonResult joint_search(const TaskSolvers& solvers, const DesignBox& box, const VectorXd& s,
                               const CodesignOptions& options) {
  JointNewtonOptions rules;
  rules.motion_tolerance = options.motion_tolerance;
  rules.design_tolerance = options.design_tolerance;
  rules.first_trust = options.largest_first_change;
  rules.largest_trust = options.largest_change;
  rules.threads = options.threads;
  rules.go_on = options.go_on;
  rules.checkpoint = options.checkpoint.in("joint");
  std::vector<WeightedCost> tasks;
  std::vector<VectorXd> first, early;
  for (const auto& solver : solvers) {
    tasks.push_back(solver->task());
    first.push_back(solver->task().initial_motion);
    if (solver->early_motion().size() > 0) early.push_back(solver->early_motion());
  }
  std::vector<std::vector<VectorXd>> starts{first};
  if (early.size() == first.size()) starts.push_back(std::move(early));
  return joint_newton(tasks, box, s, starts, rules);
}

std::vector<JointPoint> last_points(const JointNewtonResult& found, double value, const VectorXd& s,
                                    int most) {
  std::vector<JointPoint> out;
  for (const JointPoint& point : found.path)
    if (point.value < value && point.s != s) out.push_back(point);
  const auto kept = static_cast<std::size_t>(most);
  if (out.size() > kept) out.erase(out.begin(), out.end() - most);
  return out;
}

}  // namespace legwright
