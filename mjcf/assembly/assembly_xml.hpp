// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// The robot as MJCF with all angles at zero and the trunk at that height, without keyframe and
/// declarations. Servos are bodies without joint on the link that carries them, with the mass of
/// their module; links are capsules of printed material, so longer ones weigh more.
/// @param height of the trunk's frame [m]
std::string assembly_xml(const Assembly& assembly, double height);

}  // namespace legwright
