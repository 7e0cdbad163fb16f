// SPDX-License-Identifier: Apache-2.0
#include "tools/session/design_motions.hpp"

#include <algorithm>
#include <utility>

#include "optimizer/base/parallel.hpp"

namespace legwright {

using Eigen::VectorXd;

DesignMotions::DesignMotions(const std::vector<JointTask>& tasks, int threads,
                             std::function<bool()> stop)
    : threads_(threads), stop_(std::move(stop)) {
  limits_.newton.go_on = [this] { return !stop_(); };
  for (const JointTask& task : tasks)
    solvers_.push_back(std::make_unique<TaskSolver>(weighted(task, task.weight, {}), limits_));
  for (const auto& solver : solvers_) solver->minimise_outer();
}

bool DesignMotions::for_all(const std::function<bool(int)>& work) const {
  std::vector<char> done(solvers_.size());
  parallel_for(static_cast<int>(solvers_.size()), threads_,
               [&](int k) { done[k] = work(k) ? 1 : 0; });
  return std::all_of(done.begin(), done.end(), [](char c) { return c != 0; });
}

// The factor that a solve leaves may differ in its last bits from that of the point: it is made
// anew, so that a point which undo brought back predicts the same motions.
bool DesignMotions::load(const VectorXd& s, const std::vector<VectorXd>& motions) {
  return for_all(
      [&](int k) { return solvers_[k]->adopt(s, motions[k]) && solvers_[k]->differentiate(); });
}

std::vector<VectorXd> DesignMotions::predict(const std::shared_ptr<const DesignPoint>& from,
                                             const VectorXd& s) {
  std::vector<VectorXd> motions;
  for (const TaskIterate& task : from->tasks) motions.push_back(task.m);
  if (loaded_ != from) {
    loaded_ = nullptr;
    if (!load(from->s, motions)) return motions;
    loaded_ = from;
  }
  (void)for_all([&](int k) {
    motions[k] = solvers_[k]->predicted_motion(s);
    return true;
  });
  return motions;
}

std::shared_ptr<const DesignPoint> DesignMotions::settle(const VectorXd& s,
                                                         const std::vector<VectorXd>& motions) {
  loaded_ = nullptr;
  const bool finite = for_all([&](int k) {
    if (!solvers_[k]->adopt(s, motions[k])) return false;
    solvers_[k]->polish();
    return true;
  });
  if (!finite || stop_()) return nullptr;
  std::vector<VectorXd> solved;
  std::vector<SolveStatus> status;
  for (const auto& solver : solvers_) {
    solved.push_back(solver->now().m);
    status.push_back(solver->now().motion_status);
  }
  return adopt(s, solved, status);
}

std::shared_ptr<const DesignPoint> DesignMotions::adopt(const VectorXd& s,
                                                        const std::vector<VectorXd>& solved,
                                                        const std::vector<SolveStatus>& status) {
  loaded_ = nullptr;
  if (!load(s, solved)) return nullptr;
  auto point = std::make_shared<DesignPoint>();
  point->s = s;
  for (std::size_t k = 0; k < solvers_.size(); ++k) {
    point->tasks.push_back(solvers_[k]->now());
    point->tasks.back().motion_status = status[k];
  }
  loaded_ = point;
  return point;
}

}  // namespace legwright
