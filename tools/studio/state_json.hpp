// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/files/json_file.hpp"
#include "tools/session/session.hpp"

namespace legwright {

/// Where a session stands, for a page: numbers that change with every command and solve.
/// @param document how often parameters, tasks or gaits have been others
Json state_json(const SessionSnapshot& snapshot, int document);

/// What a search came to: its iteration and the parameters that are not as before.
Json point_json(const SessionState& before, const SessionState& now);

/// Two states side by side: parameters, and F of each task. `verdict` is null unless one of them
/// was judged.
Json comparison_json(const SessionState& a, const SessionState& b);

}  // namespace legwright
