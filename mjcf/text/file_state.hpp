// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace legwright {

/// What of a regular file tells whether it is as it was.
struct FileState {
  dev_t device;
  ino_t inode;
  off_t size;
  time_t seconds;  // of its last change, with the next
  long nanoseconds;
  bool operator==(const FileState&) const = default;
};

/// Nothing where there is no such file.
std::optional<FileState> state_of(const std::string& path);

}  // namespace legwright
