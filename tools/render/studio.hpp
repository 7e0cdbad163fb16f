// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/render/posing.hpp"
#include "tools/render/view.hpp"

namespace legwright {

/// The model as it is drawn: its own light, fog, field of view and quality replaced by ours.
/// @param width, height of the off-screen buffer [pixels]
ModelPointer styled_copy(const mjModel& model, int width, int height, RenderStyle style);

/// What of MuJoCo's effects a style has.
void set_effects(RenderStyle style, mjvScene& scene, mjvOption& option);

/// Half the side of the square about the point looked at in which things cast shadows [m]: all of
/// the floor near by, because outside of it the floor is grainy.
double shadow_reach(const View& view, int width, int height);

/// The same light for every scene, turned with the camera: a head light and a sun that casts the
/// shadow.
/// @param reach of the shadow [m], as told by shadow_reach
void light_studio(const View& view, double reach, mjvScene& scene);

}  // namespace legwright
