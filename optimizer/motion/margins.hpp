// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

// What a task does not give follows the robot's size, so that a robot twice as large, slower by √2,
// gets the same plan twice as large. `leg_length` is standing_leg() of the initial design, but for
// limb_clearance(), which takes Morphology::leg_length [m].

/// Leg of the robots on which weights were found that measure in absolute units [m].
inline constexpr double kKnownLeg = 0.21;

/// Planned height of a swing over what it shall step over: feet are highest late in their step,
/// splines and soft servos cut the top.
inline constexpr double kSwingOver = 2.25;

/// Lift of a swing, as a share of g times the square of its time: what a foot can rise and sink by
/// without its servos hitting their limits. 25 mm take 0.2 s.
inline constexpr double kSwingLift = 0.06;

/// The leg by whose length a robot moves [m]: as long as stretched out, but at most 1.75 times the
/// height of the COM in the home pose at design s: one that crouches swings as short a pendulum,
/// and steps as low, as a smaller one.
double standing_leg(const Morphology& morphology, const Eigen::VectorXd& s);

/// The shortest time that a foot of a gait has for its swing [s], from lift-off to touchdown.
double shortest_swing(const Gait& gait);

/// How high a foot is lifted [m]: what the task says, or a share of the leg, at most what a short
/// swing leaves time for (kSwingLift g times its square), or what stepping over a height needs.
double swing_height(const Task& task, double leg_length);

/// Distance to be kept between the centre lines of limbs, eq (16) [m]: what the task says, or a
/// share of the leg.
double limb_clearance(const Task& task, double leg_length);

/// How much earlier or later than planned a foot touches down [s]: a share of √(leg length/g), the
/// time scale of all that tips and falls.
double touchdown_error(double leg_length);

/// Square of the time that makes angular accelerations dimensionless [s²]: 4e-3 s² for legs of 21
/// cm, in proportion to the leg.
double smoothness_time_squared(double leg_length);

}  // namespace legwright
