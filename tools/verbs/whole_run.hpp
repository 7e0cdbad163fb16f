// SPDX-License-Identifier: Apache-2.0
// Whether the files of a run belong together: what comes from elsewhere is not judged or exported.
#pragma once

#include <filesystem>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/robot_files.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// Throws InputError where the task or a file of the robot in inputs/ has another SHA-256 than
/// run.json tells; what that does not know passes.
void check_inputs(const std::filesystem::path& root, const RunRecord& run, const RobotFiles& robot);
/// The same for the assets of a design.
void check_assets(const RunRecord& run, const RobotFiles& files);
/// Throws InputError where a result is not the robot of inputs/ at the design that it declares.
void check_design(const RobotModel& before, const RobotModel& after,
                  const std::filesystem::path& result);

/// All of these for a run of one task, of what is there, and whether the scenes that are played
/// were edited: runs of older programs lack files and sums. Robots that are no longer read are not
/// compared.
void check_belongs_together(const std::filesystem::path& root, const RunRecord& run);

}  // namespace legwright
