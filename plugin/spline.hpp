// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

/// A moment of the gait: the four knots whose control points act there, and with what weights.
struct SplinePhase {
  std::array<int, 4> knot{};             // in 0 … T−1
  std::array<int, 4> wrap{};             // −1, 0 or 1: cycle of that knot against the present one
  std::array<double, 4> value{};         // weights of the position,
  std::array<double, 4> rate{};          // its first derivative [1/s]
  std::array<double, 4> acceleration{};  // and its second [1/s²]
  double fraction = 0.0;                 // of the way from knot[1] to knot[2]
  double cycle = 0.0;                    // whole periods since time 0, negative before it
};

/// Where `time` [s] falls in the cycle. Any number is allowed; one that is not finite counts as 0.
SplinePhase phase_at(const Trajectory& trajectory, double time) noexcept;

/// A quantity of the played motion with its time derivatives, in the column's unit, per s and per
/// s².
struct SplinePoint {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

/// The periodic uniform cubic B-spline with the knots of `column` as control points.
/// At knot i: value (P₋ + 4P + P₊)/6, acceleration (P₋ − 2P + P₊)/h², the planner's difference.
/// @param drift by how much the column moves on in each cycle (travel, turn).
SplinePoint spline_point(const Trajectory& trajectory, const SplinePhase& phase, int column,
                         double drift = 0.0) noexcept;

/// The column between the two neighbouring knots, interpolated linearly: torques and forces, which
/// must not be smoothed over touchdown.
double linear_value(const Trajectory& trajectory, const SplinePhase& phase, int column) noexcept;

/// The whole played motion at one time; vectors in the order of the trajectory's joints and feet.
struct TrajectorySample {
  std::vector<double> target, velocity, acceleration;  // of joints: rad, rad/s, rad/s²
  std::vector<double> torque;                          // feed-forward, N·m
  // Root: x, y, z [m], then the rotation vector [rad]; the latter's derivatives are those of its
  // three numbers, not angular velocity.
  std::array<double, 6> root{}, root_rate{}, root_acceleration{};
  std::array<double, 3> com{}, com_velocity{}, com_acceleration{};
  std::vector<std::array<double, 3>> foot, foot_velocity, force;  // m, m/s, N
  std::vector<bool> contact;                                      // of the nearest knot
};

/// Samples everything, each column on its own: where the plan turns, root, COM, feet and forces
/// hold for cycle 0 only, as later ones drift along a straight line instead of going round the
/// circle; PlannedMotion has them at any time. Joints hold at any time.
/// Allocates only when `out` has other sizes than the trajectory needs.
void sample(const Trajectory& trajectory, double time, TrajectorySample& out);

}  // namespace legwright
