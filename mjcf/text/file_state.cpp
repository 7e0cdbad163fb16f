// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/file_state.hpp"

#include <sys/stat.h>

namespace legwright {

std::optional<FileState> state_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileState{status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec,
                   status.st_mtim.tv_nsec};
}

}  // namespace legwright
