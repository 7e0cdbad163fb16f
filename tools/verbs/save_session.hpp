// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/session/session.hpp"

namespace legwright {

/// Who designed, as the run's record tells it.
struct SessionMaker {
  std::vector<std::string> command{"legwright", "session"};
  std::string status = "designed in a session";  // in the place of how a search ended
  std::filesystem::path robot = {};              // its file, where the session works on a copy
};

/// Writes where a session stands as a run folder like that of `optimize --plan-only`, with the
/// session's journal beside its inputs, whose replay leads there: iteration 0 is the given body
/// with its best motion, iteration 1 and the result are the session's, motions solved. Nothing is
/// asked of MuJoCo. The session's own bounds and frozen parameters stand in the journal alone.
/// Throws InputError where the body has no finite motion, with nothing written; IoError where the
/// folder holds a run and `force` does not replace it; std::system_error.
void save_session(const SessionRecord& session, const std::filesystem::path& root, bool force,
                  const SessionMaker& maker = {});

}  // namespace legwright
