// SPDX-License-Identifier: Apache-2.0
#include "tools/run/task_folders.hpp"

#include "mjcf/text/input_error.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool within_tasks(const fs::path& folder) {
  int parts = 0;
  for (const fs::path& part : folder) {
    if (part.empty() || part == "." || part == "..") return false;
    if (parts++ == 0 && part != "tasks") return false;
  }
  return parts == 2;
}

}  // namespace

std::vector<TaskFolder> task_folders(const RunRecord& run) {
  std::vector<TaskFolder> folders;
  if (!run.joint()) return folders;
  for (const TaskRecord& task : *run.tasks) {
    const fs::path folder = task.folder.value_or("");
    if (!within_tasks(folder)) {
      throw InputError("run.json", 0, "tasks",
                       "expected a folder tasks/NAME for each task, found '" + folder.string() +
                           "'; run `legwright optimize` again");
    }
    folders.push_back({task.name, folder});
  }
  return folders;
}

std::vector<TaskFolder> task_folders_of(const fs::path& root) {
  return task_folders(read_record_file<RunRecord>(ResultFolder::open(root).run_json()));
}

}  // namespace legwright
