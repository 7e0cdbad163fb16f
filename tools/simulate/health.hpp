// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "tools/simulate/incidents.hpp"

namespace legwright {

/// The first time and number of each kind of warning in a simulation.
class Health {
 public:
  Health() { first_.fill(-1.0); }
  /// Call it after each step. @param time of the step [s]
  void look(const mjData& data, double time);
  /// A number that is none: what comes after has no meaning.
  static bool diverged(const mjData& data);
  std::vector<HealthWarning> warnings(const mjData& data) const;

 private:
  std::array<double, mjNWARNING> first_;
};

}  // namespace legwright
