// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tools/run/metrics_record.hpp"

namespace legwright {

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

/// Links of the robot below a body, by their bodies' names ("body 7" without), none of whose geoms
/// can touch another link in MuJoCo: by masks (contype, conaffinity), <pair>, <exclude>, the filter
/// of links next to each other, the switches of <option>. Nobody asks whether they do, so that they
/// may pass through others. In the order of the model.
std::vector<std::string> links_that_never_touch(const mjModel& model, int root_body);
/// How many links there are: bodies that move against each other.
int link_count(const mjModel& model, int root_body);

}  // namespace legwright
