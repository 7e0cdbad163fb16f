// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/propose/proposal.hpp"

namespace legwright {

/// The text with declarations of `proposals` in its <custom> section, which is made where there is
/// none; every other byte stays, line ends are those of the file. Throws InputError for text that
/// is no MJCF.
std::string with_declarations(const std::string& xml, const std::filesystem::path& file,
                              const std::vector<Proposal>& proposals);

}  // namespace legwright
