// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/reading_options.hpp"

#include "tools/run/run_reach.hpp"

namespace legwright {

FileReach ReadingOptions::reach() const {
  if (!confined) return {};
  return FileReach::own_folder(
      "outside of the folder of the robot's main file, and --confined was given: copy it into that "
      "folder and write its path from there, or leave --confined out");
}

void ReadingOptions::check_run(const std::filesystem::path& root) const {
  if (confined) check_reach(root, reach());
}

}  // namespace legwright
