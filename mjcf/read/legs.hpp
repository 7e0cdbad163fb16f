// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/read/structure.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Studies how a compiled robot is built: the trunk; legs, whose ends are near the ground in the
/// home pose; joints that ride along or are coupled, which are held there; feet. Throws one
/// InputError with all reasons that stand against the robot.
/// @param known what was found for another design of the same robot; null: choose legs and feet.
Structure read_structure(const XmlFile& xml, const mjModel& model,
                         const Structure* known = nullptr);

}  // namespace legwright
