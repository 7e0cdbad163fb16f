// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "tools/io/json_file.hpp"
#include "tools/io/result_folder.hpp"
#include "tools/simulate/validation.hpp"

namespace legwright {

/// What physics says about a run of one task.
struct JudgedRun {
  Json metrics, verdict;                 // as written into result/
  std::vector<SceneValidation> designs;  // initial body, result, then the others
};

/// Plays the initial design and the result of a run of one task, and any other designs for the same
/// task; writes metrics.json, verdict.json and the two playbacks into result/. Throws InputError for a
/// scene that cannot be played, IoError where the run has none.
/// @param others folders of designs: scene.xml and motion.csv
JudgedRun judge_run(const ResultFolder& folder, const std::vector<std::filesystem::path>& others,
                    const ValidationOptions& options);

/// Judges every task of a joint run, and for the trade-off every design of it at every task: the
/// initial body, the best body of each task alone, the joint result. Writes result/matrix.json, which
/// it returns. @param run run.json of the folder @param judged gets one entry per task
Json judge_joint_run(const ResultFolder& folder, const Json& run, const ValidationOptions& options,
                     std::vector<JudgedRun>& judged);

}  // namespace legwright
