// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

namespace legwright {

/// The text of a file as TOML. Throws InputError with the line where it is none, and how to mend
/// it.
toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

/// Where a key stands: its names from the root on, those of an array's entries being their numbers
/// from 0; and its line, from 1.
using KeyLine = std::pair<std::vector<std::string>, int>;

/// The lines of all keys, tables and entries of arrays, each table before what it holds. Throws
/// InputError as parse_toml().
std::vector<KeyLine> key_lines(const std::string& text, const std::filesystem::path& file);

}  // namespace legwright
