// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/solve/codesign.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// What each change of the body buys, into run.json and, of a joint run, into that of each task.
/// Does nothing where the body stayed. @param threads 0: all cores
void explain_changes(const ResultFolder& folder, const CodesignProblem& problem,
                     const DesignIteration& best, int threads, RunRecord& run);

}  // namespace legwright
