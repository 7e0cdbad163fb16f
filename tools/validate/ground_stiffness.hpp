// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/simulate/scene.hpp"

namespace legwright {

/// Weight on a planted foot [N]: the robot's over the number of feet that the plan has on the
/// ground, in the mean over the knots at which there are any.
double planted_load(const Scene& scene);

/// Time constant of `solref` for which a foot sinks in so deep while it bears the planted load
/// [s]. MuJoCo's contact at rest has R f = k s with R = (1 − d)/d · w and k = d / (dmax tc ζ)²,
/// where w is the inverse mass that it sees of the foot (body_invweight0, here the mean of the
/// feet), d = dmax the impedance and ζ = 1: hence tc = √(s d² / ((1 − d) w f)) / dmax.
/// @param sink [m], more than 0
double contact_time_for(const Scene& scene, double sink);

/// Makes what the feet stand on give way so far, never less than it did. solimp becomes constant
/// at kSoftImpedance, so that the stiffness does not depend on the depth.
void soften_ground(Scene& scene, double sink);

inline constexpr double kSoftImpedance = 0.95;

}  // namespace legwright
