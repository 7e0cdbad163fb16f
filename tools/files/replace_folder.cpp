// SPDX-License-Identifier: Apache-2.0
#include "tools/files/replace_folder.hpp"

#include <fcntl.h>
#include <stdio.h>

#include <cerrno>
#include <system_error>

namespace legwright {

namespace fs = std::filesystem;

bool exchange_at_once(const fs::path& fresh, const fs::path& old) {
  if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0)
    return true;
  for (const int cannot : {EINVAL, ENOSYS, EOPNOTSUPP, EXDEV, EBUSY})
    if (errno == cannot) return false;
  throw std::system_error(errno, std::generic_category(), old.string());
}

fs::path exchange_folders(const fs::path& fresh, const fs::path& old) {
  if (exchange_at_once(fresh, old)) return fresh;
  fs::path aside = old.parent_path() / ("." + old.filename().string() + "-replaced");
  fs::remove_all(aside);
  fs::rename(old, aside);
  fs::rename(fresh, old);
  return aside;
}

void replace_folder(const fs::path& fresh, const fs::path& old) {
  fs::remove_all(exchange_folders(fresh, old));
}

}  // namespace legwright
