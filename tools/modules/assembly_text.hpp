// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// Whether a trunk is a box of its file's own, with size and mass, and not one of the library's.
bool is_own_box(const Module& trunk);

/// An assembly as its file says it: parse_assembly() reads the same assembly back. The servo that
/// most joints have is that of the file; what is as by default is not written.
std::string assembly_text(const Assembly& assembly);

}  // namespace legwright
