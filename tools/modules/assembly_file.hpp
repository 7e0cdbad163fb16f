// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/modules/module_library.hpp"
#include "tools/task/key_table.hpp"

namespace legwright {

/// Every key of an assembly file, in the order of the reference.
const std::vector<TaskKey>& assembly_keys();

/// Whether an assembly is to be a robot, or one that is being made, which may have no limb yet.
enum class AssemblyState { whole, draft };

/// Reads an assembly strictly, with the modules that it names. Throws InputError with all that is
/// wrong: file, line, key, what was expected and how to mend it.
/// @param file for messages, and the name of the robot where the text gives none
Assembly parse_assembly(const std::string& text, const std::filesystem::path& file,
                        const ModuleLibrary& library, AssemblyState state = AssemblyState::whole);

/// Whether a TOML file is an assembly and no task file: it names no robot, and has a trunk or
/// limbs. Throws InputError where the text is no TOML.
bool is_assembly(const std::string& text, const std::filesystem::path& file);

}  // namespace legwright
