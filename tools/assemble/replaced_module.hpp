// SPDX-License-Identifier: Apache-2.0
// What goes along where a module of another size takes the place of one.
#pragma once

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/assemble/assembly_item.hpp"

namespace legwright {

/// How far a servo's body reaches behind its horn, against its axis [m].
double depth_behind_horn(const Module& servo);

/// Puts a module in the place of that of an item, which has none where it is a limb. With a trunk
/// hips and riders keep their share of its length, width and height, and their distance from its
/// faces where they stand outside; the servo of a hip keeps the place of its back, a rider that of
/// the side on which it stands on the trunk. What is of the same size moves nothing.
void replace_module(Assembly& assembly, const AssemblyItem& item, const Module& module);

}  // namespace legwright
