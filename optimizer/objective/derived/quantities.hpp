// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/objective/derived/quantity.hpp"

namespace legwright {

/// Adds all derived quantities of knots 0 … T that are wanted, in the order in which F sums over
/// them.
void list_derived(DerivedList& out);

// One function for each kind, beside its class in this folder: adds what there is of it at a knot.
void list_com(int knot, DerivedList& out);
void list_feet(int knot, DerivedList& out);
void list_swept_momentum(int knot, DerivedList& out);
void list_wrapping_momentum(int knot, DerivedList& out);
void list_foot_turns(int knot, DerivedList& out);
void list_joint_torques(int knot, DerivedList& out);
void list_trunk_points(int knot, DerivedList& out);
void list_sole_directions(int knot, DerivedList& out);
void list_actuator_shapes(int knot, DerivedList& out);
void list_mass_share(int knot, DerivedList& out);
void list_printed_volume(int knot, DerivedList& out);
void list_home_inertia(int knot, DerivedList& out);

}  // namespace legwright
