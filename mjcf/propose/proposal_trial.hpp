// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/propose/proposal.hpp"

namespace legwright {

/// Why the file with these declarations would not be read; empty if it would.
/// @param declared so many parameters the file has already
std::string refusal_of(const std::string& text, const std::filesystem::path& file, int declared,
                       const std::vector<Proposal>& proposals);

/// Why a design at the lower or the upper bounds of these could not be written and read again;
/// empty if both can.
std::string fault_at_bounds(const std::string& text, const std::filesystem::path& file,
                            const std::vector<Proposal>& proposals);

}  // namespace legwright
