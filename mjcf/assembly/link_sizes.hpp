// SPDX-License-Identifier: Apache-2.0
// Sizes of what is printed of a link, where the file gives none.
#pragma once

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// Radius of the hulls' pads, and of the capsules between joints [m]: the one given, else 6 mm; of
/// parts that are to be printed as much more as the screws of the servos need around them, and,
/// where a horn's pattern is not known, as a horn of the servo's width is wide.
double link_radius(const Assembly& assembly);

/// Radius of the pads at the other end of a link [m]: link_radius(), on a ball foot of a robot that
/// is to be printed, where none is given, within the ball.
double end_radius(const Assembly& assembly, const Module& other);

/// Thickness of the hulls' pads [m]: the one given, else 3 mm; of parts that are to be printed as
/// much more as the plate on each horn needs to bear all of its servo's torque, and twice the
/// weight on the foot beyond it, and as heads of screws that are let in need under them.
double link_wall(const Assembly& assembly);

}  // namespace legwright
