// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_reach.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"

namespace legwright {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_link(const fs::path& link) {
  throw InputError(link.string() +
                   ": is a symbolic link, which no run has; put in its place what it leads to");
}

/// Endings of what is written into runs.
constexpr std::array<std::string_view, 8> kWritten{".json", ".jsonl", ".csv",  ".xml",
                                                   ".png",  ".webp",  ".html", ".md"};
constexpr std::array<std::string_view, 7> kFolders{"result", "iterations", "tasks",     "starts",
                                                   "front",  "candidates", "checkpoint"};

template <class List>
bool is_one_of(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

void check_no_links(const fs::path& run) {
  for (const auto& entry : fs::directory_iterator(run)) {
    const std::string name = entry.path().filename().string();
    const bool is_folder = is_one_of(kFolders, name);
    const bool is_written = is_one_of(kWritten, entry.path().extension().string());
    if (entry.is_symlink() && (is_folder || is_written)) refuse_link(entry.path());
    if (!is_folder || !entry.is_directory()) continue;
    for (const auto& below : fs::recursive_directory_iterator(entry.path()))
      if (below.is_symlink() && (is_one_of(kWritten, below.path().extension().string()) ||
                                 fs::is_directory(below.path())))
        refuse_link(below.path());
  }
}

void check_reach(const fs::path& run, const FileReach& reach) {
  std::vector<fs::path> models;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    if (entry.is_symlink()) refuse_link(entry.path());
    if (entry.path().filename() == "robot.xml" || entry.path().filename() == "scene.xml")
      models.push_back(entry.path());
  }
  std::sort(models.begin(), models.end());
  for (const fs::path& model : models) (void)RobotFiles::read(model, reach);
}

}  // namespace legwright
