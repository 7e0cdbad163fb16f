// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/replace_folder.hpp"

#include <fcntl.h>
#include <stdio.h>

#include <cerrno>
#include <system_error>

namespace legwright {

namespace fs = std::filesystem;

void replace_folder(const fs::path& fresh, const fs::path& old) {
  if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(fresh);
    return;
  }
  if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP)
    throw std::system_error(errno, std::generic_category(), old.string());
  const fs::path aside = old.parent_path() / ".result-replaced";
  fs::remove_all(aside);
  fs::rename(old, aside);
  fs::rename(fresh, old);
  fs::remove_all(aside);
}

}  // namespace legwright
