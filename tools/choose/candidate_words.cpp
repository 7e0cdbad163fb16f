// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/candidate_words.hpp"

#include <fmt/format.h>

namespace legwright {

std::string words_of(const CodesignProblem& problem, const std::vector<Tightening>& tightening) {
  std::string text;
  for (std::size_t k = 0; k < tightening.size(); ++k)
    if (tightening[k].any())
      text += (text.empty() ? "" : "; ") +
              (problem.set.joint() ? problem.task(static_cast<int>(k)).name + ": " : "") +
              tightening[k].words();
  return text;
}

std::string brief_words(const CodesignProblem& problem, const PlayedCandidate& played) {
  if (played.pass) return "PASS";
  std::vector<std::string> failing;
  for (std::size_t k = 0; k < played.trials.size(); ++k) {
    const GaitTrial& trial = played.trials[k];
    if (trial.pass) continue;
    const std::string& task = problem.task(static_cast<int>(k)).name;
    failing.push_back(problem.set.joint() ? fmt::format("{} {}", task, trial.brief) : trial.brief);
  }
  return fmt::format("FAIL {}", fmt::join(failing, "; "));
}

std::optional<ByName<std::string>> failing_tasks(const CodesignProblem& problem,
                                                 const PlayedCandidate& played) {
  if (!problem.set.joint()) return std::nullopt;
  ByName<std::string> out;
  for (std::size_t k = 0; k < played.trials.size(); ++k)
    if (!played.trials[k].pass)
      out.emplace_back(problem.task(static_cast<int>(k)).name, played.trials[k].line);
  return out;
}

std::optional<ByName<PlayedGait>> played_tasks(const CodesignProblem& problem,
                                               const PlayedCandidate& played) {
  if (!problem.set.joint()) return std::nullopt;
  ByName<PlayedGait> out;
  const int count = static_cast<int>(played.trials.size());
  for (int k = 0; k < count; ++k) out.emplace_back(problem.task(k).name, played.record(k));
  return out;
}

}  // namespace legwright
