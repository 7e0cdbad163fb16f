// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/task/key_table.hpp"

namespace legwright {

/// The keys of a file for people: of each an example, what it means, what it takes and what holds
/// without it. @param scoped with where in a file of several tasks it stands
std::string key_list_text(const std::vector<TaskKey>& keys, bool scoped);

/// The same for programs: "key", "table", "forms", "in", "default", "example" and "meaning".
Json key_list_json(const std::vector<TaskKey>& keys);

}  // namespace legwright
