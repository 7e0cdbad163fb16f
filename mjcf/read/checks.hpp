// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// What can be told from the text before MuJoCo sees it: unsupported elements, numbers that MuJoCo
/// would misread or accept though no design can hold them, zero axes. Throws one InputError with
/// all such faults.
/// @param reasons names that a scene needs for itself are added here instead: they need not hide
///        what else stands against the robot
void check_text(const XmlFile& xml, Refusals& reasons);

/// The text with points for commas in attributes that hold numbers, where nothing else keeps these
/// from being read; each byte else stays where it is.
std::string with_decimal_points(const XmlFile& xml);

/// The part of check_text() that holds for any model: numbers that MuJoCo would misread, sizes that
/// fill the memory, control characters. Throws InputError.
void check_values(const XmlFile& xml);

/// Error at a body, joint or geom of the compiled model, with its line also where it has no name.
InputError error_at(const XmlFile& xml, const mjModel& model, mjtObj type, int id,
                    const std::string& message);

}  // namespace legwright
