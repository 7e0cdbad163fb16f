// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// A <numeric> that declares the motor of a joint is called so, and then like the joint.
inline constexpr std::string_view kMotorPrefix = "legwright_motor/";

/// Reads <numeric name="legwright_motor/JOINT" data="STALL_TORQUE NO_LOAD_SPEED"/> [N m, rad/s, at
/// the joint] into the servos: torque falls from the one at rest to zero at the other (MotorLine).
/// Of a joint that a linear actuator moves they are force and speed along it [N, m/s]. Those of
/// joints that are held are passed over.
/// A joint that is none of the legs', other numbers than two positive ones, and a stall torque
/// below the servo's torque limit are reasons; those of joints whose servo is refused are checked
/// alone.
void read_motor_lines(const XmlFile& xml, const Structure& structure, const Morphology& morphology,
                      std::vector<Servo>& servos, Refusals& reasons);

}  // namespace legwright
