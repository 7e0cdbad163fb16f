// SPDX-License-Identifier: Apache-2.0
// A joint that a linear actuator turns: the triangle of its hinge and the actuator's two pivots.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// The pivots of a linear actuator as drawn, from its joint, in the axes of the limb as the file
/// gives it [m].
struct LinearPivots {
  Eigen::Vector3d lever;  // of the rod, on the link that it moves
  Eigen::Vector3d mount;  // of the body, on what carries it
};

/// Those that the file gives. Without a lever: half the stroke from the joint, square to its axis
/// and to the way to the joint above, to the front. Without a mount: from the lever along that way,
/// as far as the actuator is long at half its stroke.
LinearPivots pivots_of(const AssemblyJoint& joint);

/// Length between the pivots at an angle of the joint [m].
double length_at(const AssemblyJoint& joint, double angle);
/// Moment arm there, the length's change with the angle [m/rad].
double moment_arm_at(const AssemblyJoint& joint, double angle);

/// The angles about zero at which the actuator is within its stroke and has a quarter of the moment
/// arm that it has at most, to a hundredth [rad]; narrower where the file says so.
std::array<double, 2> linear_range(const AssemblyJoint& joint);

/// The module with the pivot of its body at the mount and its rod towards the lever, from the
/// joint; its longer side away from it. `roll` turns it about its rod.
Eigen::Isometry3d linear_pose(const AssemblyJoint& joint);

/// Mass of the rotor as the rod feels it [kg]: what the module tells; else 0.03 s times the force
/// at rest over the speed without load: what the servos' 0.005 kg m² for each N m comes to at their
/// 6 rad/s (docs/findings/reflected_inertia.md). None where the speed is not known.
std::optional<double> reflected_mass(const ModuleSlide& slide);

/// Why the actuator cannot turn the joint as drawn: no moment arm, out of its stroke. Empty where
/// it can.
std::string why_not_turned(const AssemblyJoint& joint);

}  // namespace legwright
