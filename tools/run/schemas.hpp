// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace legwright {

/// The JSON Schema of every file of a run folder, by its name in docs/schema/ without
/// ".schema.json". Those of events are of a line of events.jsonl without its "crc".
std::vector<std::pair<std::string, nlohmann::ordered_json>> record_schemas();

}  // namespace legwright
