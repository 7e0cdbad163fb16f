// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "tools/files/json_file.hpp"
#include "tools/session/state.hpp"

namespace legwright {

/// A motion of a state as a page plays it: where each body is over one cycle, and which feet stand
/// and push; faults of the plan where they are.
/// `up` is against gravity in the frame of the ground, `step` the height over which feet step [m].
/// @param model of the state's design, as drawn_model() makes it
Json motion_json(const SessionState& state, int task, const mjModel& model);

/// The same joint angles and trunk on another body of the robot: poses alone.
Json motion_on_body(const SessionState& state, int task, const mjModel& model);

}  // namespace legwright
