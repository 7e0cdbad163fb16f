// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// Refuses a robot that is to be printed, `Assembly::print`, whose parts fail a check of
/// `legwright parts` as drawn, but for the size on the bed, which a design may mend: with the lines
/// of the assembly and the words, figures and remedies of that command, which is asked. Throws
/// InputError with all of them.
/// @param xml of the robot. @param file of the assembly
/// @return a note where no Python is there to ask; else empty
std::string refuse_unprintable(const Assembly& assembly, const std::string& xml,
                               const std::filesystem::path& file);

}  // namespace legwright
