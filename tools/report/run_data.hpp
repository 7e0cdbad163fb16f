// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"
#include "tools/report/judged_data.hpp"
#include "tools/run/certificate_record.hpp"
#include "tools/run/iteration_record.hpp"
#include "tools/run/matrix_record.hpp"
#include "tools/run/run_record.hpp"
#include "tools/run/strength_record.hpp"

namespace legwright {

/// What a run folder holds, read for a report: what is missing is missing, what is broken is noted.
struct RunData : JudgedData {
  std::filesystem::path root;
  std::string title;  // robot, and task or name of a joint run; never empty
  RunRecord run;
  std::vector<IterationEvent> iterations;  // of a run of one task, in order
  std::vector<JointIterationEvent> joint_iterations;
  std::optional<CertificateRecord> certificate;  // of the result; none where it was not asked for
  std::optional<MatrixRecord> matrix;            // of a joint run; none before validate
  std::optional<FrontRecord> front;              // the same; none where it was not asked for
  std::optional<StrengthRecord> strength;        // of printed parts; of a run as printed alone
  std::optional<Trajectory> initial_plan, result_plan;
  std::vector<std::string> notes;  // files that could not be used, and why

  std::filesystem::path iteration(int index) const;
};

/// Throws IoError where the folder has no run.json or one that does not say what it should; faults
/// of all other files go to the notes.
RunData read_run(const std::filesystem::path& root);

/// Whether the body was kept and only its gait optimised.
bool motion_only(const RunData& data);

}  // namespace legwright
