// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/drawables/drawn_design.hpp"
#include "tools/files/json_file.hpp"
#include "tools/modules/module_library.hpp"

namespace legwright {

/// An assembly as a page shows it, all angles zero and its lowest point on the ground: {name, mass,
/// joints, trunk, parts, limbs, spots, design, items}. Places are in the trunk's frame [m]; `items`
/// says for each body of `design` which item it is of, "" of the world. Throws InputError where
/// MuJoCo refuses the body.
Json assembly_json(const Assembly& assembly, MeshStore& meshes);

/// What there is to choose from, sorted by kind, then by name: {modules: [{name, kind, maker,
/// about, mass, stall_torque, no_load_speed, max_force, stroke, rod_speed}]}; what a kind has not
/// is null.
Json palette_json(const ModuleLibrary& library);

/// A module by itself: {bodies, geoms, poses}.
Json module_picture(const Module& module, MeshStore& meshes);

}  // namespace legwright
