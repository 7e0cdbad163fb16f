// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "tools/run/run_lock.hpp"

namespace legwright {

/// A run that is built in a hidden folder beside the one whose place it takes when it stands: until
/// then that one is as it was, whatever ends the process.
class RunBuild {
 public:
  /// Removes what killed builds have left, under the lock of the run, which the caller holds.
  /// Throws IoError where the run cannot be replaced: somebody's own files lie in it, it is a mount
  /// point, or the process works in it; std::system_error where nothing can be made beside it.
  RunBuild(const std::filesystem::path& run, std::shared_ptr<const RunLock> lock);
  /// Removes a build that does not stand; its checkpoint goes to the run that stays.
  ~RunBuild();
  RunBuild(const RunBuild&) = delete;
  RunBuild& operator=(const RunBuild&) = delete;

  /// Where the new run is: beside the old one, and in its place once it stands.
  const std::filesystem::path& at() const { return at_; }
  /// Whether both folders are where they were.
  bool is_there() const;
  /// Takes the place of the old run, which goes away. Throws std::system_error.
  void stand();

 private:
  std::filesystem::path named_, target_, at_;
  std::shared_ptr<const RunLock> old_lock_;
  std::unique_ptr<RunLock> lock_;
  bool stands_ = false;
};

/// Moves the checkpoint of a build whose process was killed to the run that it was to replace, if
/// that has none or an older one and nobody writes there.
void rescue_checkpoint(const std::filesystem::path& run);

/// Removes files that killed processes have left in a run. Its lock must be held.
void sweep_leftovers(const std::filesystem::path& run);

}  // namespace legwright
