// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <optional>
#include <vector>

#include "tools/simulate/scene.hpp"
#include "tools/validate/stage_progress.hpp"

namespace legwright {

/// A model at a moment of its cycle, from which it is played on for one.
struct CycleStart {
  const mjModel* model = nullptr;  // whose time step fits into the period a whole number of times
  const mjData* data = nullptr;
  int steps = 0;      // of a cycle
  int root_body = 0;  // that a free joint moves; 0: there is none
};

struct FloquetOptions {
  int settle_cycles = 10;  // played before the cycle that is looked at
  double step = 3e-3;      // of the differences, in units of length, angle and their speeds
  int threads = 2;
  ProgressListener progress = {};
  std::function<bool()> stop = {};  // asked now and then; true: throws RolloutStopped
};

/// The largest Floquet multiplier of a cycle: by how much the cycle multiplies a small disturbance
/// of the state, in the direction that it enlarges most in the long run. Below 1 the robot comes
/// back to its gait by itself. It is the largest magnitude of an eigenvalue of the return map's
/// Jacobian, taken by central differences of qpos and qvel. Where a free robot is on the ground and
/// which way it faces is left out, as nothing pulls it back (multiplier 1); on a slope the heading
/// counts. Lengths are measured in heights of the root body, speeds in those over √(height / g).
/// Smaller differences than the default's find the grid of touchdowns in steps (docs/findings/
/// stability.md). The same bits for any number of threads. Nothing where a disturbed state
/// diverges.
std::optional<double> floquet_multiplier(const CycleStart& start, const FloquetOptions& options);

/// The same of the gait of a scene at its gains, once it is on its way. Nothing where it falls
/// before. The time step is shortened to one of which a whole number makes a cycle.
std::optional<double> floquet_multiplier(const Scene& scene, const FloquetOptions& options = {});

/// Of several scenes, as fast as the threads allow.
std::vector<std::optional<double>> floquet_multipliers(const std::vector<Scene>& scenes,
                                                       const FloquetOptions& options = {});

}  // namespace legwright
