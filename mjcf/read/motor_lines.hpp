// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// A <numeric> that declares the motor of a joint is called so, and then like the joint.
inline constexpr std::string_view kMotorPrefix = "legwright_motor/";

/// Reads <numeric name="legwright_motor/JOINT" data="STALL_TORQUE NO_LOAD_SPEED"/> [N m, rad/s, at
/// the joint] into the servos: torque falls from the one at rest to zero at the other (MotorLine).
/// Throws InputError for a joint without servo or with a linear actuator, for other numbers than
/// two positive ones, and for a stall torque below the servo's torque limit.
void read_motor_lines(const XmlFile& xml, std::vector<Servo>& servos);

}  // namespace legwright
