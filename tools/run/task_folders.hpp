// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/run/run_record.hpp"

namespace legwright {

/// A task of a joint run, which is a complete run folder of its own.
struct TaskFolder {
  std::string name;
  std::filesystem::path relative;  // to the joint run: tasks/NAME
};

/// The tasks of a joint run, in order; none for a run of one task.
/// Throws InputError where it names a folder that is not tasks/NAME: nothing
/// outside the run may be read or written.
std::vector<TaskFolder> task_folders(const RunRecord& run);

/// The same by the folder of a run. Throws IoError where it holds none.
std::vector<TaskFolder> task_folders_of(const std::filesystem::path& root);

}  // namespace legwright
