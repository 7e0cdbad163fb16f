// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "mjcf/affine.hpp"
#include "mjcf/linear_actuators.hpp"
#include "mjcf/printed.hpp"
#include "mjcf/read_robot.hpp"
#include "mjcf/xml.hpp"

namespace legwright {

/// Geom ids of the feet, in order of their links: on each last link of a limb the colliding ball
/// that is lowest in the home pose. Throws InputError for a limb without one.
std::vector<int> find_feet(const XmlFile& xml, const mjModel& model, int trunk);

/// Builds the kinematic tree of the compiled robot with the stretches, turns and places of its
/// design parameters.
Morphology build_morphology(const mjModel& model, int trunk, const std::vector<int>& foot_geoms,
                            const DesignSpace& space, const std::vector<Binding>& bindings,
                            const StretchMap& stretches, const PlaceMap& places,
                            const PrintedMap& printed, const std::vector<TendonSpan>& tendons);

/// The keyframe named "home"; −1 if there is none (then the home pose is all angles zero).
int home_keyframe(const mjModel& model);

}  // namespace legwright
