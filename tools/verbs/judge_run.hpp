// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mjcf/propose/home_touches.hpp"
#include "mjcf/read/solver_options.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/matrix_record.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/validate/records.hpp"

namespace legwright {

/// What physics says about a run of one task.
struct JudgedRun {
  MetricsRecord metrics;                     // as written into result/
  VerdictRecord verdict;                     // likewise
  std::vector<SceneValidation> designs;      // initial body, result, then the others
  Verdict verdict_at_gains;                  // on the result, by what the others are asked, too
  std::optional<SecondOpinion> numerics;     // on the result
  std::optional<Robustness> robustness;      // of the result
  std::vector<HomeTouch> home_touches;       // of the designed body, which the initial one has not
  std::vector<OverriddenOption> overridden;  // of the robot's file, by the scenes
  JudgedSums of;                             // what was judged, when it was loaded

  std::optional<NumericsRecord> numerics_record() const;
  std::optional<RobustnessRecord> robustness_record() const;
};

struct JudgeOptions {
  ValidationOptions validation;  // with the limits
  bool numerics = true;          // ask for the second opinion
  bool robustness = true;        // play under disturbances
  bool stability = true;         // Floquet multipliers of the result
  RobustnessOptions disturbed = {};
  bool write = true;  // what is judged into the run
};

/// "the search was interrupted: …": what a verdict of a run must say that did not come to its end;
/// empty where it did. @param status of run.json
std::string early_stop_words(const std::string& status);

/// Plays the initial design and the result of a run of one task, and any other designs for the same
/// task. Throws InputError for a scene that cannot be played, IoError where the run has none or was
/// replaced meanwhile.
/// @param others folders of designs: scene.xml and motion.csv
JudgedRun play_and_judge(const ResultFolder& folder,
                         const std::vector<std::filesystem::path>& others,
                         const JudgeOptions& options);

/// Writes metrics.json, comparison.json, numerics.json, robustness.json, the two playbacks and, as
/// the last one, verdict.json, which names the others by their sums, into result/. Of what was not
/// asked for no old file stays, nor pictures of another judgement. Throws IoError, and writes
/// nothing, where the run is no longer the one that was judged.
void write_judged(const ResultFolder& folder, JudgedRun& judged);

/// Both; where nothing is to be written only looks at whether the run is still the one.
JudgedRun judge_run(const ResultFolder& folder, const JudgeOptions& options);

/// Judges every task of a joint run, and for the trade-off every design of it at every task: the
/// initial body, the best body of each task alone, the joint result. Writes what write_judged()
/// does, of all tasks once all are judged, then result/matrix.json, which it returns; or nothing.
/// @param run run.json of the folder @param judged gets one entry per task
MatrixRecord judge_joint_run(const ResultFolder& folder, const RunRecord& run,
                             const JudgeOptions& options, std::vector<JudgedRun>& judged);

}  // namespace legwright
