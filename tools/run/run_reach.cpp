// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_reach.hpp"

#include <algorithm>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"

namespace legwright {

namespace fs = std::filesystem;

void check_reach(const fs::path& run, const FileReach& reach) {
  std::vector<fs::path> models;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    if (entry.is_symlink())
      throw InputError(entry.path().string() +
                       ": is a symbolic link, which no run has; put in its place what it leads to");
    if (entry.path().filename() == "robot.xml" || entry.path().filename() == "scene.xml")
      models.push_back(entry.path());
  }
  std::sort(models.begin(), models.end());
  for (const fs::path& model : models) (void)RobotFiles::read(model, reach);
}

}  // namespace legwright
