// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/run/result_folder.hpp"
#include "tools/validate/validation.hpp"

namespace legwright {

/// What a run of one task asks of its designs.
struct TaskOfRun {
  std::string gait;
  WantedMotion wanted;
  double step_over = 0.0;                      // that every foot shall pass over [m]
  std::optional<std::string> early_stop = {};  // status of a search that did not end
};

/// Throws InputError where run.json is of no such run, IoError where it cannot be read.
TaskOfRun task_of_run(const ResultFolder& folder);

/// The scene of a design and what its plan reaches. Throws IoError where there is none.
/// @param folder scene.xml and motion.csv
SceneToValidate scene_to_validate(const std::filesystem::path& folder);

}  // namespace legwright
