// SPDX-License-Identifier: Apache-2.0
#include "tools/files/link_folder.hpp"

#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool has_access_list(const fs::path& folder) {
  constexpr std::array kLists{"system.posix_acl_access", "system.posix_acl_default"};
  return std::any_of(kLists.begin(), kLists.end(), [&](const char* list) {
    return ::getxattr(folder.c_str(), list, nullptr, 0) >= 0;
  });
}

bool give_owner_of(const fs::path& from, const fs::path& to) {
  struct stat wanted {
  }, had{};
  if (::stat(from.c_str(), &wanted) != 0 || ::stat(to.c_str(), &had) != 0) return false;
  return (wanted.st_uid == had.st_uid && wanted.st_gid == had.st_gid) ||
         ::chown(to.c_str(), wanted.st_uid, wanted.st_gid) == 0;
}

/// Whether the file system does not give it a second name, whose disk is as it should be.
bool is_refused(const std::error_code& error) {
  constexpr std::array kRefusals{EPERM, EACCES, EXDEV, EMLINK, EOPNOTSUPP, ENOSYS};
  return std::find(kRefusals.begin(), kRefusals.end(), error.value()) != kRefusals.end();
}

}  // namespace

bool link_folder(const fs::path& from, const fs::path& to) {
  // What may not be written could not be removed, either, when the other has its place.
  if (::access(from.c_str(), W_OK) != 0 || has_access_list(from) || !give_owner_of(from, to))
    return false;
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path name = to / entry.path().filename();
    if (entry.is_directory() && !entry.is_symlink()) {
      fs::create_directory(name);
      if (!link_folder(entry.path(), name)) return false;
      continue;
    }
    std::error_code error;
    fs::create_hard_link(entry.path(), name, error);
    if (error && is_refused(error)) return false;
    if (error) throw fs::filesystem_error("cannot link", entry.path(), name, error);
  }
  fs::permissions(to, fs::status(from).permissions());
  return true;
}

}  // namespace legwright
