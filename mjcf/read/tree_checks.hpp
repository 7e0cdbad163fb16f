// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// The body with the free joint; −1, with a reason, if there is none. A second one is a reason too.
int find_trunk(const XmlFile& xml, const mjModel& model, Refusals& reasons);

/// What stands against a robot whatever its legs are: gravity, keyframes of a wrong length, geoms
/// that collide but belong to something else, bodies moved from outside.
void check_surroundings(const XmlFile& xml, const mjModel& model, int trunk, Refusals& reasons);

/// What stands against a joint that moves in the plan: type, name. @return false where what follows
/// cannot be asked of it
bool check_leg_joint(const XmlFile& xml, const mjModel& model, int joint, Refusals& reasons);

/// What a name in a trajectory may not hold.
inline constexpr const char* kNoNameSigns = " \t\r\n;,|~^";
/// Why trajectories cannot name something so; empty where they can.
std::string fault_of_name(const std::string& name);

}  // namespace legwright
