// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/files/json_file.hpp"

namespace legwright {

/// The file of the running program. Throws std::filesystem::filesystem_error where the system does
/// not tell.
std::filesystem::path program_file();

/// The words of the command line that started this process, its own name first.
std::vector<std::string> command_line();

/// Versions of what a result depends on: legwright, mujoco, eigen, cholmod, compiler. Libraries
/// that are loaded are asked; "not loaded" where they are not.
Json versions();
/// Of Legwright alone.
std::string program_version();

/// The largest memory this process has had so far [MiB].
double peak_memory_mib();

}  // namespace legwright
