// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tools/run/result_folder.hpp"
#include "tools/session/session.hpp"

namespace legwright {

/// Writes where a session stands as a run folder like that of `optimize --plan-only`, with the
/// session's journal beside its inputs, whose replay leads there: iteration 0 is the given body
/// with its best motion, iteration 1 and the result are the session's, motions solved. Nothing is
/// asked of MuJoCo. Throws InputError where the body has no finite motion, std::system_error.
void save_session(const SessionRecord& session, const ResultFolder& folder);

}  // namespace legwright
