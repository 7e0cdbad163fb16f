// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "mjcf/assembly/module.hpp"

namespace legwright {

/// What of a module's figures can be and is hardly meant, as they are far from all that the library
/// has: torque and power for the mass, speed, density, places off the outline, angles. Each with
/// file, line and key, what is odd, and the unit that is probably meant.
std::vector<std::string> doubts_on_module(const Module& module, const toml::table& toml,
                                          const std::filesystem::path& file);

}  // namespace legwright
