// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/choose/candidate.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// "larger margins"; of several tasks "pace: larger margins".
std::string words_of(const CodesignProblem& problem, const std::vector<Tightening>& tightening);

/// For a terminal: "PASS", or "FAIL" with what fails; the whole is in run.json.
std::string brief_words(const CodesignProblem& problem, const PlayedCandidate& played);

/// Of several tasks those that fail, with what physics says of each.
std::optional<ByName<std::string>> failing_tasks(const CodesignProblem& problem,
                                                 const PlayedCandidate& played);

/// Of several tasks what physics says of each.
std::optional<ByName<PlayedGait>> played_tasks(const CodesignProblem& problem,
                                               const PlayedCandidate& played);

}  // namespace legwright
