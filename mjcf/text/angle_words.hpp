// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// Whether a file's angles are in degrees, as its <compiler> has it; without a word of it MJCF's
/// are. Keyframes are in radians whatever it says.
bool angles_in_degrees(const XmlFile& xml);

/// An angle [rad] as the file has it: "-160 degrees", "-2.79 rad".
std::string angle_text(double angle, bool in_degrees);
/// The same in two digits, for estimates.
std::string rough_angle_text(double angle, bool in_degrees);
/// A range likewise: "-160 to -2 degrees".
std::string angle_range_text(double lower, double upper, bool in_degrees);

}  // namespace legwright
