// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <system_error>

namespace legwright {

/// A path at which something is written that shall get another name, or a mark of who is at work.
/// remove_unfinished() takes it away where a signal ends the process before.
class UnfinishedPath {
 public:
  /// Registers it; nothing need be there yet.
  explicit UnfinishedPath(std::filesystem::path path);
  ~UnfinishedPath();
  UnfinishedPath(const UnfinishedPath&) = delete;
  UnfinishedPath& operator=(const UnfinishedPath&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Gives what is there its name, as rename(2) does: from then on it stays, whatever ends the
  /// process.
  std::error_code rename_to(const std::filesystem::path& target);

 private:
  void forget();
  std::filesystem::path path_;
};

/// While one lives, remove_unfinished() waits: what is changed meanwhile is changed whole.
class WholeChange {
 public:
  WholeChange();

 private:
  std::lock_guard<std::recursive_mutex> held_;
};

/// Removes what stands at registered paths, the latest first. For a process that ends: who would
/// register another path from then on, or take one back, waits for ever.
void remove_unfinished() noexcept;

}  // namespace legwright
