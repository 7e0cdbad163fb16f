// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// <limit velocity> from which on it stands for none [rad/s]; urdf_of() writes it so.
inline constexpr double kNoSpeedLimit = 1000.0;

/// <limit velocity> of a URDF's joints by name [rad/s], which MuJoCo's reader passes over. Without
/// those that are missing, 0, or stand for none.
std::map<std::string, double> speed_limits(const XmlFile& urdf);

/// A motor of a URDF, which tells two limits and nothing between: its effort is there up to half of
/// its velocity limit, and falls to nothing at that. The line of a motor of twice the effort at
/// rest is that, as the effort limits it besides (MotorLine).
/// @param effort [N m] @param speed [rad/s]
/// @return the data of a <numeric name="legwright_motor/JOINT">
std::string motor_line_data(double effort, double speed);

/// The sentence on the motors that have such a line. @param joints how many, at least one
/// @param slowest the least of their limits [rad/s] @param fastest the largest
std::string speed_limits_note(int joints, double slowest, double fastest);

}  // namespace legwright
