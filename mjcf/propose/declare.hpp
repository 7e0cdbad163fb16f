// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "mjcf/propose/proposal.hpp"

namespace legwright {

/// How the lines of a text end: "\n", or "\r\n" where there is such a line.
std::string line_end(const std::string& text);

/// The text with declarations of `proposals` in its <custom> section, which is made where there is
/// none; every other byte stays, line ends are those of the file. Throws InputError for text that
/// is no MJCF.
std::string with_declarations(const std::string& xml, const std::filesystem::path& file,
                              const std::vector<Proposal>& proposals);

/// The text with a name for each unnamed body that directly holds one of these joints: the joint's,
/// with "_body" behind it where a body has that already. Bodies in included files stay unnamed.
std::string with_named_bodies(const std::string& xml, const std::filesystem::path& file,
                              const std::set<std::string>& joints);

/// The text with lines in a section of that name under its root, which is made where there is none
/// or where it is empty; else as above. @param lines without their indent and line ends
std::string with_lines_in_section(const std::string& xml, const std::filesystem::path& file,
                                  const char* section, const std::vector<std::string>& lines);

}  // namespace legwright
