// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/motion/task.hpp"

namespace legwright {

// What a task does not give follows the robot's size, so that a robot twice as large, slower by √2, gets the same plan
// twice as large. `leg_length` is that of the morphology [m].

/// Leg of the robots on which weights were found that measure in absolute units [m].
inline constexpr double kKnownLeg = 0.21;

/// Planned height of a swing over what it shall step over: feet are highest late in their step, splines and soft servos
/// cut the top.
inline constexpr double kSwingOver = 2.25;

/// How high a foot is lifted [m]: the task's wish, or a share of the leg, or what stepping over a height needs.
double swing_height(const Task& task, double leg_length);

/// Distance to be kept between the centre lines of limbs, eq (16) [m]: the task's wish, or a share of the leg.
double limb_clearance(const Task& task, double leg_length);

/// How much earlier or later than planned a foot touches down [s]: a share of √(leg length/g), the time scale of all
/// that tips and falls.
double touchdown_error(double leg_length);

/// Square of the time that makes angular accelerations dimensionless [s²]: 4e-3 s² for legs of 21 cm, in proportion to
/// the leg.
double smoothness_time_squared(double leg_length);

}  // namespace legwright
