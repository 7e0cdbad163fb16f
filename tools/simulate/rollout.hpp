// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulate/health.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {

/// One moment of a roll-out. All that MuJoCo derives from the state (xpos, contacts, forces,
/// actuator lengths and velocities) belongs to `time`; data.qpos and data.qvel are one step ahead
/// already.
struct RolloutSample {
  const mjModel& model;
  const mjData& data;
  double time;  // [s] since the start
};

/// When the robot is taken for fallen.
struct FallLimits {
  double tilt = 1.0;          // of the trunk's z axis from the vertical [rad]
  double height_share = 0.4;  // of the trunk's height at the start
};

struct RolloutOptions {
  int cycles = 20;
  FallLimits fall = {};
  double frame_interval = 0.01;  // of recorded frames [s]
  double frame_until = 0.0;      // record frames up to here [s]; 0: none
  // For disturbed roll-outs:
  std::function<void(mjData&)> prepare = {};       // changes the state at the keyframe
  std::function<void(mjData&, double)> step = {};  // does the work of mj_step, at this time [s]
};

struct RolloutFrame {
  double time;
  std::vector<double> qpos;
};

struct Rollout {
  double seconds = 0.0;  // simulated
  std::optional<Fall> fall;
  std::vector<HealthWarning> warnings;
  bool diverged = false;  // a state that is no number: stopped there
  std::vector<RolloutFrame> frames;
};

/// Plays a scene from its keyframe for whole cycles, headless, as fast as it goes. Stops early at a
/// fall or when the simulation diverges; MuJoCo never resets it. The same scene gives the same
/// bits.
/// @param observe called for each step with what holds at its beginning, and once for the end.
Rollout rollout(const Scene& scene, const RolloutOptions& options,
                const std::function<void(const RolloutSample&)>& observe = {});

}  // namespace legwright
