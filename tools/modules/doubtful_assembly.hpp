// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/modules/module_library.hpp"

namespace legwright {

/// What of an assembly can be and is hardly meant: a box heavier than metal, vectors far longer
/// than the trunk, angles of more than a turn, links of foam, feet with less friction than the
/// floor of tasks; and what is doubtful about the modules that it names. Each with file, line and
/// key, what is odd, and the unit that is probably meant.
/// @param assembly as parse_assembly() reads it from the text
std::vector<std::string> doubts_on_assembly(const Assembly& assembly, const std::string& text,
                                            const std::filesystem::path& file,
                                            const ModuleLibrary& library);

}  // namespace legwright
