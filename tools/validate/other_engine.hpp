// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <functional>
#include <map>

#include "tools/simulate/scene.hpp"

namespace legwright {

/// One step of another physics engine, in the coordinates of a scene's model.
struct EngineStep {
  Eigen::VectorXd qpos, qvel;  // at its end; not finite where the engine gave up
  Eigen::VectorXd torque;      // of the servos, in the order of the plan's joints [N m]
  /// Force of the ground on each geom that touches it, by its id: world axes [N].
  std::map<int, Eigen::Vector3d> ground_force;
};

/// Plays one step of the scene's time step, from where the last one ended; the first from the
/// keyframe. @param time at its start [s]
using EngineStepper = std::function<EngineStep(double time)>;

/// How another engine begins a roll-out of a scene.
using EngineStart = std::function<EngineStepper(const Scene& scene)>;

/// The step of a roll-out (RolloutOptions::step) whose states come from another engine: MuJoCo
/// derives from them what is measured, but for the torques of the servos and the forces of the
/// ground, which are the engine's own. Where the robot touches itself is what MuJoCo's geoms say at
/// these states. Keeps a reference to the scene. Throws std::invalid_argument for a step of other
/// sizes than the scene has.
std::function<void(mjData&, double)> played_by(const Scene& scene, EngineStepper step);

}  // namespace legwright
