// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace legwright {

/// Keeps other writers away from the folder of a run for as long as it lives: an exclusive flock on
/// the file `.lock` in it, which says who holds it. Readers need none. The kernel releases that of
/// a killed process, whose file is in nobody's way. A task of a joint run is locked with the whole
/// run. Where a file system knows no such locks, nobody is kept away.
class RunLock {
 public:
  static constexpr const char* kFile = ".lock";

  /// @param run an existing folder. Throws IoError, with who it is, where somebody else writes
  /// there; std::system_error where the file cannot be made.
  explicit RunLock(const std::filesystem::path& run);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Whether the folder at its path is still the locked one.
  bool stands() const;
  /// The locked folder: that of the run, or of the joint run that a task belongs to.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
};

/// The folder of the run in which a path lies or will lie; none where it lies in no run.
std::optional<std::filesystem::path> run_around(const std::filesystem::path& path);

}  // namespace legwright
