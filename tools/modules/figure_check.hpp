// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>

#include "tools/modules/module_file.hpp"
#include "tools/task/toml_reader.hpp"

namespace legwright {

/// Adds a problem for each figure that has no source or assumption, that one names and the file
/// does not give, or that a module of its kind may have and the file leaves out.
/// @param given figures whose keys are there, also with a value that is refused.
/// @param kind_known whether the kind is one; else nothing of a kind is asked for
/// @param lines of keys
void check_figures(const ModuleFile& file, const std::set<std::string>& given, bool kind_known,
                   const std::map<std::string, int>& lines, Problems& problems);

}  // namespace legwright
