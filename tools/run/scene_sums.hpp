// SPDX-License-Identifier: Apache-2.0
// Scenes alone are played: run.json has the SHA-256 of each, so that an edited one is not judged or
// drawn in the place of the run's.
#pragma once

#include <filesystem>

#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// Gives the record the sums of all scenes of a run that is about to end; of a joint run those of
/// its starts, candidates and front, and writes those of each task into the run.json of that task.
void note_scenes(const ResultFolder& folder, RunRecord& run);
/// Gives it that of its result, after another design took that place.
/// @param root of the run, or of one task of several
void note_result_scene(const std::filesystem::path& root, RunRecord& run);

/// Throws InputError where the scene in a folder of designs was edited since the run wrote it. What
/// run.json does not know, as in runs of older programs, passes, and what is not there.
/// @param root of the run; of a design below tasks/NAME that task's run.json tells
void check_scene(const std::filesystem::path& root, const RunRecord& run,
                 const std::filesystem::path& design);
/// The same for the result, of a joint run for that of each task.
void check_result_scenes(const std::filesystem::path& root, const RunRecord& run);
/// The same for every scene of a run of one task, or of one task of several.
void check_scenes(const std::filesystem::path& root);

}  // namespace legwright
