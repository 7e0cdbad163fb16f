// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace legwright {

/// The highest group of geoms that is drawn, in MuJoCo's viewer too unless it is told otherwise.
inline constexpr int kHighestSeenGroup = 2;

/// The group of each geom for drawing: its own, but one that is not drawn for shapes that only
/// collide and have pictures in their place. These are geoms of a group in which all geoms of the
/// robot collide, on bodies that show a geom of a group in which none does. MuJoCo makes such a
/// model of a URDF. All else keeps its group: a foot on a body without pictures, and balls and
/// capsules in one group with what they decorate.
std::vector<int> drawn_groups(const mjModel& model);

/// Gives the geoms of a model those groups: of one that is nothing but drawn.
void hide_collision_shapes(mjModel& model);

}  // namespace legwright
