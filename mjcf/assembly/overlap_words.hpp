// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "mjcf/propose/module_overlaps.hpp"

namespace legwright {

/// Modules of an assembly's robot that stand inside each other, in words of its file: both names
/// and lines, how deep along which axis, and what to move. Pairs that the same tables of the file
/// make, as mirror images and copies do, are told once, by the deepest of them.
std::vector<std::string> overlap_notes(const Assembly& assembly,
                                       const std::vector<ModuleOverlap>& overlaps);

/// Refuses those of which the middle of one is in the other, which no outline drawn too large
/// explains; of a robot that is to be printed, `Assembly::print`, all but those of the trunk, as no
/// part holds both. Throws InputError with their lines, all of them at once.
/// @param file of the assembly
void refuse_overlaps(const Assembly& assembly, const std::vector<ModuleOverlap>& overlaps,
                     const std::filesystem::path& file);

}  // namespace legwright
