// SPDX-License-Identifier: Apache-2.0
#include "tools/files/unfinished_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
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

/// Opens a folder and locks it as long as the descriptor is open; −1 where another process has it,
/// or it is no longer there.
int lock_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat opened {};
  struct stat named {};
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &opened) == 0 &&
      ::stat(folder.c_str(), &named) == 0 && opened.st_ino == named.st_ino)
    return descriptor;
  ::close(descriptor);
  return -1;
}

/// Removes what killed processes have left: folders that nobody holds.
void sweep(const fs::path& target) {
  const fs::path around = target.parent_path().empty() ? "." : target.parent_path();
  const std::string head = head_of(target);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(around, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(head) || !has_tail(std::string_view(name).substr(head.size()))) continue;
    const int held = lock_folder(entry.path());
    if (held < 0) continue;
    fs::remove_all(entry.path(), ignored);
    ::close(held);
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
    if (!fs::create_directory(path)) continue;
    held_ = lock_folder(path);
    if (held_ < 0 && !fs::exists(path)) continue;  // swept by another process before it was held
    path_ = path;
    return;
  }
}

UnfinishedFolder::~UnfinishedFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (held_ >= 0) ::close(held_);
}

void UnfinishedFolder::appear() {
  fs::rename(path_, target_);
  path_.clear();
}

}  // namespace legwright
