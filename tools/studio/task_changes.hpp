// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/files/json_file.hpp"

namespace legwright {

/// The text of a task file with keys of one of its tasks changed: {"gait": {"period": 0.8},
/// "payload": null}. Keys are those of the task file, null takes a key or a table out; all else
/// stays as it is. Throws InputError where a change can be no key.
/// @param task of the [[task]] tables, or of a file without them 0
std::string with_changes(const std::string& text, int task, const Json& changes);

}  // namespace legwright
