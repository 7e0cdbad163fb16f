// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "optimizer/solve/codesign.hpp"

namespace legwright {

/// The finished design with one changed parameter at its old value, all others as designed, and
/// the motions solved anew. What that costs is what the change buys in the finished design. Such
/// costs do not add up to the whole fall of F: changes help each other, or do the same work.
struct PutBack {
  int parameter = 0;
  Eigen::VectorXd s;
  std::vector<Eigen::VectorXd> motions;    // of the tasks
  std::vector<double> decrease;            // of each Fᵢ by the change; infinite without a motion
  std::vector<double> outer_decrease;      // of each Jᵢ
  std::vector<std::vector<double>> terms;  // by task: decrease of each term of Fᵢ, in their order
  SolveStatus motion_status = SolveStatus::iteration_limit;  // the worst of the tasks

  /// Σ wᵢ of the decreases of Fᵢ and Jᵢ.
  double total(const std::vector<WeightedCost>& tasks) const;
};

struct PutBackOptions {
  MotionLimits limits = put_back_limits();
  std::function<bool()> stop = {};  // asked before each row: true leaves the rest out

  static MotionLimits put_back_limits();
};

/// Puts each parameter back whose value at the result is not that of `old_values`; a tied group is
/// one parameter. Motions start from the result's. Rows come in the order of the parameters, and
/// their bits do not depend on the number of threads.
/// @param threads the same tasks once for each thread, each with costs of its own
/// @param result a design with its motions
[[nodiscard]] std::vector<PutBack> put_back(const std::vector<std::vector<WeightedCost>>& threads,
                                            const Eigen::VectorXd& old_values,
                                            const DesignIteration& result,
                                            const PutBackOptions& options = {});

}  // namespace legwright
