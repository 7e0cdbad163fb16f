// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/files/json_file.hpp"

namespace legwright {

/// The table of keys of a task file (task/key_table.hpp) with the terms that `weights` names: for
/// people, and for docs/task_file.md.
std::string keys_text();
Json keys_json();

}  // namespace legwright
