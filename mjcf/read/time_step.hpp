// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Writes into each servo how much a torque at its joint accelerates it in the home pose, with the
/// rest of the robot free: the entry of the joint-space inertia's inverse, (M⁻¹)_jj [1/(kg m²)].
/// @param model the file's, for messages at `file`
void read_mobility(const mjModel& model, const std::filesystem::path& file,
                   std::vector<Servo>& servos);

/// Step of scenes of a robot [s]: 1 ms, or a half or a quarter of it where servos damp links that
/// are light for them. Where the damping's rate times the step is beyond three or so, trots lose
/// speed that they keep at shorter steps (measured: docs/findings/time_step.md).
double step_of_scenes(const std::vector<Servo>& servos);

/// "scenes take steps of 0.25 ms, not 1 ms, as …" with the joint for which they do and what would
/// change it; empty where they take the usual ones.
std::string describe_step(const std::vector<Servo>& servos);

}  // namespace legwright
