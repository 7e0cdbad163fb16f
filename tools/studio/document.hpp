// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/session/state.hpp"
#include "tools/studio/handles.hpp"

namespace legwright {

/// Everything of a session that changes rarely: parameters with their handles, tasks, gaits of the
/// library, terms of F.
/// @param model of the state's design, as drawn_model() makes it
Json document_json(const SessionState& state, const std::vector<Handle>& handles,
                   const mjModel& model);

}  // namespace legwright
