// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "mjcf/read/structure.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Joints that something besides the tree ties together: equality constraints between joints or
/// tendons, tendons over joints or round geoms that pull. By joint id: what does it, "fixed tendon
/// 'cable'".
std::map<int, std::string> coupled_joints(const XmlFile& xml, const mjModel& model);

/// The joint that a tendon stands for: of a fixed one over that alone, at which nothing but
/// actuators pulls; −1 for others.
int lone_joint(const mjModel& model, int tendon);

/// Whether a tendon runs straight from a site to a site.
bool joins_two_sites(const mjModel& model, int tendon);
/// All joints that the bodies of a tendon have between them.
std::vector<int> joints_under(const mjModel& model, int tendon);

/// Joints that actuators drive by tendons over several, by joint id: the actuator's name.
std::map<int, std::string> joints_of_driven_tendons(const mjModel& model);

/// Equality constraints that close a loop: active ones between bodies which the plan moves against
/// each other, or between a body and the world.
void check_loops(const XmlFile& xml, const mjModel& model, const Structure& structure,
                 Refusals& reasons);

}  // namespace legwright
