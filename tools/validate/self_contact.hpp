// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <set>
#include <string>
#include <utility>

namespace legwright {

/// How a robot touched itself during a roll-out, legs against legs for instance.
struct SelfContact {
  double share = 0.0;         // of the time in which any two of its bodies touch
  int count = 0;              // touches: of any two bodies, from their meeting to their parting
  double force_max = 0.0;     // largest normal force between two bodies [N]
  double force_time = 0.0;    // when that was [s], since the start
  std::string first, second;  // between which bodies; empty if there was none
};

/// Follows the contacts of a robot with itself. Two bodies that touch at several points touch once,
/// and their forces add up. What belongs to the world, like the floor, does not count.
class SelfContactWatch {
 public:
  explicit SelfContactWatch(const mjModel& model) : model_(model) {}

  /// @param time [s]; rising @param data whose contacts and forces belong to it
  void observe(double time, const mjData& data);
  SelfContact finish() const;

 private:
  using Pair = std::pair<int, int>;  // bodies, the smaller id first

  const mjModel& model_;
  std::set<Pair> touching_;
  Pair hardest_{-1, -1};
  long long samples_ = 0, touched_ = 0;
  SelfContact out_;
};

}  // namespace legwright
