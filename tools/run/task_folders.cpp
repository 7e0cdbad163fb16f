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

std::string text_of(const Json& task, const char* key) {
  if (!task.is_object()) return "";
  const auto found = task.find(key);
  return found != task.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

std::vector<TaskFolder> task_folders(const Json& run) {
  std::vector<TaskFolder> folders;
  const auto tasks = run.is_object() ? run.find("tasks") : run.end();
  if (tasks == run.end() || !tasks->is_array()) return folders;
  for (const Json& task : *tasks) {
    const fs::path folder = text_of(task, "folder");
    if (!within_tasks(folder)) {
      throw InputError("run.json", 0, "tasks",
                       "expected a folder tasks/NAME for each task, found '" + folder.string() +
                           "'; run `legwright optimize` again");
    }
    folders.push_back({text_of(task, "name"), folder});
  }
  return folders;
}

std::vector<TaskFolder> task_folders_of(const fs::path& root) {
  return task_folders(read_json(ResultFolder::open(root).run_json()));
}

}  // namespace legwright
