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
  /// What was solved for already. The first that is told stays; nobody is waited for.
  void set(SolvedMotions solved) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock && !known_) known_ = std::move(solved);
  }
  /// @param solve called where nobody has solved for them yet; what it throws is passed on
  SolvedMotions get(const std::function<SolvedMotions()>& solve) {
    const std::lock_guard lock(mutex_);
    if (!known_) known_ = solve();
    return *known_;
  }

 private:
  std::mutex mutex_;
  std::optional<SolvedMotions> known_;
};

}  // namespace legwright
