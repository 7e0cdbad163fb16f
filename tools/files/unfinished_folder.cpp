// SPDX-License-Identifier: Apache-2.0
#include "tools/files/unfinished_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

namespace legwright {

namespace fs = std::filesystem;

UnfinishedFolder::UnfinishedFolder(const fs::path& target) : target_(target) {
  if (!target.parent_path().empty()) fs::create_directories(target.parent_path());
  // Never a folder that is there already: it may be somebody's, or another process is filling it.
  const std::string stem = fmt::format(".{}.{}", target.filename().string(), getpid());
  for (int n = 0;; ++n) {
    const fs::path path = target.parent_path() / fmt::format("{}.{}.tmp", stem, n);
    if (!fs::create_directory(path)) continue;
    path_ = path;
    return;
  }
}

UnfinishedFolder::~UnfinishedFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void UnfinishedFolder::appear() {
  fs::rename(path_, target_);
  path_.clear();
}

}  // namespace legwright
