// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "optimizer/solve/task_solver.hpp"
#include "tools/session/state.hpp"

namespace legwright {

/// The motions of all tasks at a design: first-order ones at once, eq (4), and m*(s). What comes
/// out depends on the numbers that go in, not on what was asked before.
class DesignMotions {
 public:
  /// Keeps references to the costs. @param threads at most one per task is of use; results do not
  /// depend on it @param stop asked before each Newton step
  DesignMotions(const std::vector<JointTask>& tasks, int threads, std::function<bool()> stop);

  /// Motions of another design, predicted from a solved one; where the prediction has more F there
  /// than the motion as it is, that.
  std::vector<Eigen::VectorXd> predict(const std::shared_ptr<const DesignPoint>& from,
                                       const Eigen::VectorXd& s);
  /// m*(s) from these motions. Null where `stop` said so or F is not finite; where Newton's method
  /// gets no further its best is taken, and its status says so.
  std::shared_ptr<const DesignPoint> settle(const Eigen::VectorXd& s,
                                            const std::vector<Eigen::VectorXd>& motions);
  /// The same of motions that settle() found, with the ends of their solves. Null where F or its
  /// derivatives are not finite.
  std::shared_ptr<const DesignPoint> adopt(const Eigen::VectorXd& s,
                                           const std::vector<Eigen::VectorXd>& solved,
                                           const std::vector<SolveStatus>& status);

 private:
  bool for_all(const std::function<bool(int)>& work) const;
  bool load(const Eigen::VectorXd& s, const std::vector<Eigen::VectorXd>& motions);

  int threads_;
  std::function<bool()> stop_;
  MotionLimits limits_;
  TaskSolvers solvers_;
  std::shared_ptr<const DesignPoint> loaded_;  // that the solvers are at
};

}  // namespace legwright
