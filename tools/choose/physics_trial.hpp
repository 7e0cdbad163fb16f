// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/read/read_robot.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/task/task_file.hpp"
#include "tools/validate/physics_steps.hpp"

namespace legwright {

/// The least that a missed limit adds to the distance from passing. A gait that fails in other
/// numerics alone stays below.
inline constexpr double kMissedLimit = 0.5;

/// For how long a gait is played. One that fails within its first cycles fails; two that do can be
/// compared only after as many cycles.
enum class PlayLength { first_cycles, until_failure, whole };

/// What physics says of a gait, for the choice between designs.
struct GaitTrial : PhysicsTrial {
  /// How far it is from passing: 0 where it passes; each limit that it misses at a gain adds one
  /// half and the logarithm of one plus the excess over the limit, in sizes of the limit. A fall
  /// adds ten times the share of the time that is missing.
  double distance = 0.0;
  double speed_ratio = 1.0;    // in the middle between the gains; 1 where unknown
  double heading_drift = 0.0;  // the same [rad a cycle]
  int rollouts = 0;            // that it took
};

/// Plays a planned gait in MuJoCo as `validate` does, over as many cycles and at the same gains,
/// and judges it by the same limits; then, where it passes, with half the step at the highest gains
/// and with a pyramidal cone at these and the default ones. The first cycles alone ask no other
/// numerics.
/// Throws MujocoError for a scene that cannot be played; needs load_gait_plugin() before.
/// @param wanted the task that the gait is judged by, which it need not be planned for
/// @param threads of the gains; results do not depend on it
GaitTrial try_in_physics(const RobotModel& robot, const TaskFile& wanted, const DesignTexts& texts,
                         int threads = 1, PlayLength length = PlayLength::until_failure);

}  // namespace legwright
