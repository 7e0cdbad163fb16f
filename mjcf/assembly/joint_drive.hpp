// SPDX-License-Identifier: Apache-2.0
// What turns a joint of an assembly, as numbers of its robot: a servo, or a linear actuator.
#pragma once

#include <array>
#include <optional>

#include "mjcf/assembly/robot_assembly.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

/// At the joint [N m/rad], [N m s/rad]; of a linear actuator along its rod [N/m], [N s/m].
struct DriveGains {
  double kp, kv;
};

/// Those that the module advises, else by its limit; of a linear actuator so much damping that the
/// rotor, as heavy as its rod feels it, swings half as much as undamped.
DriveGains drive_gains(const AssemblyJoint& joint, const Assembly& assembly);

/// Of the joint [rad]: the file's, else the servo's; of a linear actuator linear_range().
std::optional<std::array<double, 2>> drive_range(const AssemblyJoint& joint);

/// Torque at rest and speed without load, of a linear actuator force and speed along its rod; none
/// where the speed is not known.
std::optional<MotorLine> drive_line(const Module& servo);

}  // namespace legwright
