// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/read/read_robot.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/task/task_file.hpp"
#include "tools/validate/physics_steps.hpp"

namespace legwright {

/// How often MuJoCo plays a gait while it is judged: at half, default and double gains, and at the
/// latter with other numerics.
inline constexpr int kTrialRollouts = 4;

/// What physics says of a gait, for the choice between designs.
struct GaitTrial : PhysicsTrial {
  /// How far it is from passing: 0 where it passes; each limit that it misses at a gain adds one
  /// half and the logarithm of one plus the excess over the limit, in sizes of the limit. A fall
  /// adds ten times the share of the time that is missing.
  double distance = 0.0;
  double speed_ratio = 1.0;    // in the middle between the gains; 1 where unknown
  double heading_drift = 0.0;  // the same [rad a cycle]
};

/// Plays a planned gait in MuJoCo as `validate` does, over as many cycles and at the same gains,
/// and judges it by the same limits; then, where it passes, with a pyramidal cone at the highest
/// gains. A gait that fails within its first cycles is not played on,
/// unless it shall be played to the end: two that fail can be compared only after as many cycles.
/// Throws MujocoError for a scene that cannot be played; needs load_gait_plugin() before.
/// @param wanted the task that the gait is judged by, which it need not be planned for
/// @param threads of the gains; results do not depend on it
GaitTrial try_in_physics(const RobotModel& robot, const TaskFile& wanted, const DesignTexts& texts,
                         int threads = 1, bool to_the_end = false);

}  // namespace legwright
