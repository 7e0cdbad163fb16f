// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "optimizer/solve/status.hpp"

namespace legwright {

/// Motions m*(s) of one body, one for each task, and how their solves ended.
struct SolvedMotions {
  std::vector<Eigen::VectorXd> motions;
  std::vector<SolveStatus> status;
};

/// The motions of the body that a problem was given, which are solved for once: a session sets out
/// from them, and each run that it is saved as tells them. May be asked from any thread.
class GivenMotions {
 public:
  /// What was solved for already. The first that is told stays.
  void set(SolvedMotions found) {
    const std::lock_guard lock(mutex_);
    if (!found_) found_ = std::move(found);
  }
  /// @param solve called where nobody has solved for them yet; what it throws is passed on
  SolvedMotions get(const std::function<SolvedMotions()>& solve) {
    const std::lock_guard lock(mutex_);
    if (!found_) found_ = solve();
    return *found_;
  }

 private:
  std::mutex mutex_;
  std::optional<SolvedMotions> found_;
};

}  // namespace legwright
