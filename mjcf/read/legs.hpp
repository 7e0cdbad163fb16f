// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/read/structure.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// How a robot is built, as far as it can be told.
struct FoundStructure {
  Structure structure;
  bool is_whole = true;  // false: legs may lack feet, and joints that are refused count as held
};

/// Studies how a compiled robot is built: the trunk; legs, whose ends are near the ground in the
/// home pose; joints that ride along or are coupled, which are held there; feet. What stands
/// against the robot is added to `reasons`; throws InputError where it has no trunk.
/// @param known what was found for another design of the same robot; null: choose legs and feet.
FoundStructure read_structure(const XmlFile& xml, const mjModel& model, const Structure* known,
                              Refusals& reasons);

}  // namespace legwright
