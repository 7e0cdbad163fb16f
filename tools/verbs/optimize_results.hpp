// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/choose/choose_design.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"
#include "tools/verbs/close_gap.hpp"
#include "tools/verbs/recorder.hpp"

namespace legwright {

/// Writes what stands in a run's folder before anything is solved. From then on the run has files
/// of its own: what becomes of the user's does not matter to it. Throws std::system_error.
/// @param problem its robot's files become those of the folder @return run.json
RunRecord write_start(const ResultFolder& folder, CodesignProblem& problem, bool motion_only,
                      const std::vector<std::string>& command);

/// How a search ended. @param signal that ended it, or 0
std::string status_text(SolveStatus status, int signal);

/// Whether a design has a finite motion for each task.
bool usable(const DesignIteration& iteration);

/// Writes the results of a run, and what run.json says of them. @param chosen the design that is
/// handed back. @param was_to_play whether MuJoCo was to be asked; where run.choice is none all the
/// same, no task is feasible. @param status of the run: how it ended
/// @param warn of what the engine warns
void write_end(const ResultFolder& folder, const CodesignProblem& problem,
               const MultistartResult& found, const Candidate& chosen, bool was_to_play,
               const std::string& status, Recorder& recorder, RunRecord& run,
               const std::function<void(const std::string&)>& warn);

/// Writes the designs beside the result that physics was asked about into candidates/, and notes
/// where they are.
void write_candidates(const ResultFolder& folder, const CodesignProblem& problem,
                      const ChosenDesign& choice, ChoiceRecord& record);

/// Proves the result, an optimum of F as its search had it, and writes certificate.json beside it.
/// @return what run.json says of it
CertificateNote write_certificate(const ResultFolder& folder, const CodesignProblem& problem,
                                  const std::vector<JointTask>& tasks, const Candidate& chosen,
                                  int threads);

/// After the adjoint loop: what MuJoCo says of the gaits, and steps that it confirms. Noted in
/// run.json: of each task where there are several.
void close_gaps(const ResultFolder& folder, const CodesignProblem& problem, const Candidate& chosen,
                const CloseGapOptions& options, RunRecord& run);

}  // namespace legwright
