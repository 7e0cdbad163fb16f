// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// The armature of a joint [kg m2]: what the module's file tells; else what the assembly gives;
/// else, of a geared servo, 0.005 for each N m of stall torque, as gaits hang on details without
/// any (docs/findings/reflected_inertia.md). None of brushless joints that tell none.
std::optional<double> reflected_inertia(const ModuleJoint& joint, const Assembly& assembly);

/// The armature of a joint, also of one that a linear actuator turns: of that reflected_mass() at
/// the moment arm that it has as drawn, where the assembly gives none.
std::optional<double> armature_of(const AssemblyJoint& joint, const Assembly& assembly);

/// Of which servos it is not known, and what is taken in its place: up to two notes.
std::vector<std::string> notes_on_inertia(const Assembly& assembly);

}  // namespace legwright
