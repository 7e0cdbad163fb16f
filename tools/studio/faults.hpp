// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "tools/files/json_file.hpp"
#include "tools/session/state.hpp"

namespace legwright {

/// What is wrong with a plan now, and where: each constraint of F that is broken, at a foot, a
/// joint or between two limbs, over consecutive knots, the worst first. `from` and `to` are phases
/// of the cycle. @param model of the state's design, as drawn_model() makes it
Json faults_json(const SessionState& state, int task, const mjModel& model);

}  // namespace legwright
