// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// The connectors that lie where a cable of the next module leaves, as no other attachment faces
/// the horn: `legwright parts` cuts the cable's slot through them. Each with the line of the module
/// in the assembly and what mends it; once for all mirror images and copies.
std::vector<std::string> notes_on_cables(const Assembly& assembly);

}  // namespace legwright
