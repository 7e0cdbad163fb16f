// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/modules/module_file.hpp"

namespace legwright {

/// Modules as a table, a line each, kind by kind.
std::string module_table(const std::vector<ModuleFile>& modules);

/// One module: its figures, each with how many sources give it, sources, assumptions and what is
/// not known.
std::string module_page(const ModuleFile& module);

Json to_json(const ModuleFile& module);

}  // namespace legwright
