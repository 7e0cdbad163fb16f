// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_reach.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "tools/run/own_files.hpp"

namespace legwright {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_link(const fs::path& link) {
  throw InputError(link.string() +
                   ": is a symbolic link, which no run has; put in its place what it leads to");
}

/// Folders of a run that are written into; those of the robot's files are the user's.
constexpr std::array<std::string_view, 7> kWritten{"result", "iterations", "tasks",     "starts",
                                                   "front",  "candidates", "checkpoint"};

}  // namespace

void check_no_links(const fs::path& run) {
  for (const auto& entry : fs::directory_iterator(run)) {
    const std::string name = entry.path().filename().string();
    const bool is_folder = std::find(kWritten.begin(), kWritten.end(), name) != kWritten.end();
    if (entry.is_symlink() && (is_folder || is_name_of_runs(name))) refuse_link(entry.path());
    if (!is_folder || !entry.is_directory()) continue;
    for (const auto& below : fs::recursive_directory_iterator(entry.path()))
      if (below.is_symlink() && is_name_of_runs(below.path().filename().string()))
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
