// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "plugin/trajectory.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

constexpr int kFewestFrames = 48;

/// One cycle of a trajectory as a page plays it: {period, frames, bodies, poses, advance, feet,
/// forces, places}. Poses are those of every body of the model [m, unit quaternions wxyz, world];
/// forces on the feet [N] and places of them [m] are the plan's; arrays are base64 of float32,
/// frame by frame; of a foot its name and in which frames it stands.
/// @param fewest_frames there are at least two for each knot
/// Throws MujocoError where the model lacks a joint.
Json motion_frames_json(const mjModel& model, const Trajectory& trajectory,
                        int fewest_frames = kFewestFrames);

}  // namespace legwright
