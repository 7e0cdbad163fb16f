// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_json.hpp"
#include "tools/task/problem.hpp"
#include "tools/verbs/recorder.hpp"

namespace legwright {

/// Where the result of a task belongs: result/, or tasks/TASK/result/ where there are several.
std::filesystem::path result_folder(const ResultFolder& folder, const CodesignProblem& problem,
                                    int task);

/// Makes tasks/TASK a run folder of its own for each task of a joint run, which validate, render,
/// report and play take like any other: iteration 0000 is the initial body, then come the
/// iterations of the start that won. Also writes result/robot.xml, the body that all tasks share.
/// @param run what is known of the joint run, finished
void write_task_runs(const ResultFolder& folder, const CodesignProblem& problem,
                     const RunRecord& run, const MultistartResult& found,
                     std::vector<TaskOutcome>& outcomes, Recorder& recorder);

/// Walks the trade-off of two tasks and writes result/front.json. @return its points
std::vector<FrontPointRecord> write_front(const ResultFolder& folder,
                                          const CodesignProblem& problem,
                                          const std::vector<JointTask>& tasks,
                                          const MultistartResult& found, int points,
                                          const CodesignOptions& options);

}  // namespace legwright
