// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/files/unfinished_path.hpp"

namespace legwright {

/// Keeps other writers away from the folder of a run for as long as it lives: an exclusive flock on
/// the file `.lock` in it, which says who holds it. Readers need none. The kernel releases that of
/// a killed process, whose file is in nobody's way. A task of a joint run is locked with the whole
/// run. Where a file system knows no such locks, nobody is kept away.
class RunLock {
 public:
  static constexpr const char* kFile = ".lock";
  enum class Extent {
    whole_run,    // of a task the joint run that it belongs to
    this_folder,  // alone
  };

  /// @param run an existing folder. Throws IoError, with who it is, where somebody else writes
  /// there; std::system_error where the file cannot be made.
  explicit RunLock(const std::filesystem::path& run, Extent extent = Extent::whole_run);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Whether the folder at its path is still the locked one.
  bool stands() const;
  /// After the folder was renamed. @param folder its path now
  void moved_to(const std::filesystem::path& folder);
  /// Tells readers of a folder beside in which a new run is being built; empty: of none.
  void note(const std::string& build) const;
  /// The locked folder: that of the run, or of the joint run that a task belongs to.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::string since_;
  int descriptor_ = -1;
  std::optional<UnfinishedPath> file_;
};

/// Where the new run is being built that will take the place of a run; none where nobody builds
/// one. For those who watch.
std::optional<std::filesystem::path> build_beside(const std::filesystem::path& run);

/// The folder of the run in which a path lies or will lie; none where it lies in no run.
std::optional<std::filesystem::path> run_around(const std::filesystem::path& path);

}  // namespace legwright
