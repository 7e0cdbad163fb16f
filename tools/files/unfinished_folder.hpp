// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "tools/files/unfinished_path.hpp"

namespace legwright {

/// A folder that is filled and then appears whole under its name, or not at all.
class UnfinishedFolder {
 public:
  /// Makes a hidden folder of a new name, `.NAME.….tmp`, beside `target`, and removes those that
  /// killed processes have left. Throws std::filesystem::filesystem_error.
  explicit UnfinishedFolder(const std::filesystem::path& target);
  /// Removes what was not handed over.
  ~UnfinishedFolder();
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;

  const std::filesystem::path& path() const { return path_->path(); }
  /// Gives it its name. Throws std::filesystem::filesystem_error where a folder with files has it.
  void appear();

 private:
  std::filesystem::path target_;
  std::optional<UnfinishedPath> path_;  // empty: it has its name
  int held_ = -1;                       // the folder, locked: nobody else sweeps it
};

}  // namespace legwright
