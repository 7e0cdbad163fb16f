// SPDX-License-Identifier: Apache-2.0
#include "tools/files/unfinished_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Head of the names of folders that shall become `target`.
std::string head_of(const fs::path& target) { return "." + target.filename().string() + "."; }

/// Whether a name ends as those do: two numbers and ".tmp".
bool has_tail(std::string_view tail) {
  constexpr std::string_view kEnd = ".tmp";
  if (!tail.ends_with(kEnd)) return false;
  tail.remove_suffix(kEnd.size());
  const auto digits = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t dot = tail.find('.');
  return dot != std::string_view::npos && digits(tail.substr(0, dot)) &&
         digits(tail.substr(dot + 1));
}

/// What came of locking a folder.
struct FolderLock {
  int descriptor = -1;     // the lock holds as long as it is open; −1: there is none
  bool is_others = false;  // another process has it, or had, and removed the folder
};

FolderLock lock_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return {-1, errno == ENOENT};
  struct stat opened {};
  struct stat named {};
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const bool is_others = errno == EWOULDBLOCK;  // else a file system without locks
    ::close(descriptor);
    return {-1, is_others};
  }
  if (::fstat(descriptor, &opened) == 0 && ::stat(folder.c_str(), &named) == 0 &&
      opened.st_ino == named.st_ino)
    return {descriptor, false};
  ::close(descriptor);
  return {-1, true};
}

/// Removes what killed processes have left: folders that nobody holds.
void sweep(const fs::path& target) {
  const fs::path around = target.parent_path().empty() ? "." : target.parent_path();
  const std::string head = head_of(target);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(around, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(head) || !has_tail(std::string_view(name).substr(head.size()))) continue;
    const FolderLock lock = lock_folder(entry.path());
    if (lock.descriptor < 0) continue;
    fs::remove_all(entry.path(), ignored);
    ::close(lock.descriptor);
  }
}

}  // namespace

UnfinishedFolder::UnfinishedFolder(const fs::path& target) : target_(target) {
  if (!target.parent_path().empty()) fs::create_directories(target.parent_path());
  sweep(target);
  // Never a folder that is there already: it may be somebody's, or another process is filling it.
  for (int n = 0;; ++n) {
    const fs::path path =
        target.parent_path() / fmt::format("{}{}.{}.tmp", head_of(target), getpid(), n);
    const WholeChange whole;  // that it is there and that it is registered
    if (!fs::create_directory(path)) continue;
    const FolderLock lock = lock_folder(path);
    if (lock.is_others) continue;  // swept by another process before it was held
    held_ = lock.descriptor;
    path_.emplace(path);
    return;
  }
}

UnfinishedFolder::~UnfinishedFolder() {
  std::error_code ignored;
  if (path_) fs::remove_all(path_->path(), ignored);
  if (held_ >= 0) ::close(held_);
}

void UnfinishedFolder::appear() {
  if (const std::error_code error = path_->rename_to(target_))
    throw fs::filesystem_error("cannot rename", path_->path(), target_, error);
  path_.reset();
}

}  // namespace legwright
