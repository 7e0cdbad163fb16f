// SPDX-License-Identifier: Apache-2.0
#include "tools/io/unfinished_folder.hpp"

#include <fmt/format.h>

#include <system_error>

namespace legwright {

namespace fs = std::filesystem;

UnfinishedFolder::UnfinishedFolder(const fs::path& target)
    : target_(target),
      path_(target.parent_path() / fmt::format(".{}.tmp", target.filename().string())) {
  fs::remove_all(path_);
  fs::create_directories(path_);
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
