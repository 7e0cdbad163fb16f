// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/design/payload.hpp"
#include "optimizer/motion/cycle_target.hpp"
#include "optimizer/motion/gait.hpp"

namespace legwright {

/// The right-hand side of the torque balance, eq (13).
enum class Dynamics {
  full,              // the rate of angular momentum of all masses as they move
  constant_inertia,  // the paper's I ö, with I of the home pose
};

/// A task: all of F that is not the robot. SI units.
struct Task {
  std::string name;
  Gait gait;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // along x, y of the heading frame [m/s]
  double turn_rate = 0.0;                              // [rad/s], positive to the left

  // Where it shall do it, and with what. The plan's frame is that of the ground: on a slope gravity
  // is what is oblique.
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // against gravity, unit vector
  std::optional<Payload> payload;                 // fixed to the trunk
  /// Each motor has no more than this, if it has more [N m]; linear actuators keep their force.
  std::optional<double> torque_limit;
  /// Servos at joints that are softer are played as stiff as this [N m/rad], as far as their torque
  /// limit bears it, and damped so [N m s/rad]; the plan knows nothing of it. Not given: servos are
  /// as the robot's file has them.
  std::optional<double> servo_kp, servo_kd;
  double step_over = 0.0;  // height over which every swing shall step; validation measures it [m]

  // Style targets, eqs (10): what is not given is taken from the home pose of the initial design.
  std::optional<double> com_height;  // [m]
  std::optional<std::vector<Eigen::Vector2d>>
      footprint;  // foot − COM on the ground, robot's foot order [m]
  /// Whether the footprint follows the hips of the design: what its width and length add to the
  /// hips they add to the places. Not given: the home footprint does, one given above does not.
  std::optional<bool> follow_hips;
  // The same over the cycle (see over_cycle.hpp): any number of values, evenly spaced in time, or
  // none.
  std::vector<double> com_heights;        // instead of com_height [m]
  std::vector<Eigen::Vector2d> com_path;  // COM off the wanted path: forward, left [m]
  std::vector<std::vector<Eigen::Vector2d>>
      foot_targets;  // per foot, instead of its footprint; a foot without keeps that
  // Per foot and per joint of the pose, or none; who has no target is left alone.
  std::vector<CycleTarget> foot_heights;  // of the sole over the ground while it swings [m]
  std::vector<CycleTarget> joint_angles;  // [rad]

  // Margins of the plan (physics needs them; see optimizer/README.md).
  double friction = 0.4;               // of the plan; the floor has more
  double floor_friction = 0.8;         // of the scene's floor
  std::optional<double> swing_height;  // [m]; not given: a share of the leg (margins.hpp)
  double min_normal = 0.05;            // least normal force of a stance foot, share of the weight
  int planted_margin = 1;              // knots planted beyond stance on either side, at least 1
  double joint_margin = 0.0;           // distance kept from joint limits [rad]
  double torque_margin = 0.1;          // share of each motor's torque limit that is kept in hand
  std::optional<double> clearance;     // between the centre lines of limbs, eq (16) [m]; likewise
  /// Limb segments to keep apart, by the names of their links or feet; not given: all that are not
  /// neighbours.
  std::optional<std::vector<std::pair<std::string, std::string>>> limb_pairs;
  double barrier_edge = 0.02;  // slack below which an inequality's barrier turns into a parabola

  Dynamics dynamics = Dynamics::full;
  std::map<std::string, double> weights;  // by term name, overrides the registry's default
};

/// Unit vector against gravity as a ground sees it that rises by `along` on the way to go (forward,
/// left) and by `across` to the left of that way [rad]. A way of zero length counts as forward.
Eigen::Vector3d up_on_slope(const Eigen::Vector2d& way, double along, double across);

/// The same angles back [rad].
struct SlopeAngles {
  double along = 0.0, across = 0.0;
};
SlopeAngles slope_of(const Eigen::Vector2d& way, const Eigen::Vector3d& up);

/// The robot as it does the task: with its payload, and with motors no stronger than the task
/// allows.
Morphology as_in_task(const Morphology& morphology, const Task& task);

}  // namespace legwright
