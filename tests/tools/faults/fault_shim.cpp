// SPDX-License-Identifier: Apache-2.0
// Preloaded into a program: lets its n-th call to the file system fail, or ends the process there.
// Counted are calls that open, read, write, name or remove what lies below a folder.
//   FAULT_ROOT   the folder, as realpath() has it
//   FAULT_AT     which call, from 1; 0: none
//   FAULT_HOW    kill, EIO (this call alone) or ENOSPC (this and all later ones that need room)
//   FAULT_COUNT  a file that gets the number of calls when the process ends
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/tools/faults/open_calls.hpp"

namespace {

struct Plan {
  std::string root, count;
  long at = 0;
  int error = 0;  // 0: kill
  Plan() {
    const auto text = [](const char* name) {
      const char* const value = std::getenv(name);
      return std::string(value == nullptr ? "" : value);
    };
    root = text("FAULT_ROOT");
    count = text("FAULT_COUNT");
    at = std::atol(text("FAULT_AT").c_str());
    const std::string how = text("FAULT_HOW");
    error = how == "EIO" ? EIO : how == "ENOSPC" ? ENOSPC : 0;
  }
};

const Plan& plan() {
  static const Plan made;
  return made;
}

std::atomic<long> calls{0};

bool is_below(const char* path) {
  if (plan().root.empty() || path == nullptr) return false;
  if (path[0] != '/') return true;  // the program is started in the folder
  return std::strncmp(path, plan().root.c_str(), plan().root.size()) == 0;
}

bool is_below(int descriptor) {
  char link[64], path[4096];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = ::readlink(link, path, sizeof path - 1);
  if (size < 0) return false;
  path[size] = '\0';
  return path[0] == '/' && is_below(path);
}

/// Whether this call fails; errno says how. @param needs_room whether a full disk ends it
bool fails(bool below, bool needs_room) {
  if (!below) return false;
  const long number = ++calls;
  if (plan().at <= 0 || number < plan().at) return false;
  if (plan().error == 0 && number == plan().at) ::kill(::getpid(), SIGKILL);
  const bool now = plan().error == ENOSPC ? needs_room : plan().error != 0 && number == plan().at;
  if (now) errno = plan().error;
  return now;
}

struct AtExit {
  ~AtExit() {
    if (plan().count.empty()) return;
    if (FILE* const file = std::fopen(plan().count.c_str(), "w")) {
      std::fprintf(file, "%ld\n", calls.load());
      std::fclose(file);
    }
  }
} at_exit;

bool fails_to_open(const char* path, int flags) {
  return fails(is_below(path), (flags & O_CREAT) != 0);
}

}  // namespace

// Each stands before the library's function of that name. NOLINTBEGIN
#define SHIM(result, name, parameters, arguments, below, needs_room, failed) \
  extern "C" result name parameters {                                        \
    static const auto real = next<result(*) parameters>(#name);              \
    if (fails(below, needs_room)) return failed;                             \
    return real arguments;                                                   \
  }

SHIM(int, mkdir, (const char* path, mode_t mode), (path, mode), is_below(path), true, -1)
SHIM(int, rmdir, (const char* path), (path), is_below(path), false, -1)
SHIM(int, unlink, (const char* path), (path), is_below(path), false, -1)
SHIM(int, remove, (const char* path), (path), is_below(path), false, -1)
SHIM(int, unlinkat, (int folder, const char* path, int flags), (folder, path, flags),
     is_below(path), false, -1)
SHIM(int, rename, (const char* from, const char* to), (from, to), is_below(to), true, -1)
SHIM(int, renameat2, (int a, const char* from, int b, const char* to, unsigned flags),
     (a, from, b, to, flags), is_below(to), true, -1)
SHIM(int, link, (const char* from, const char* to), (from, to), is_below(to), true, -1)
SHIM(int, symlink, (const char* from, const char* to), (from, to), is_below(to), true, -1)
SHIM(int, chmod, (const char* path, mode_t mode), (path, mode), is_below(path), false, -1)
SHIM(int, fchmod, (int file, mode_t mode), (file, mode), is_below(file), false, -1)
SHIM(int, ftruncate, (int file, off_t size), (file, size), is_below(file), true, -1)
SHIM(int, fsync, (int file), (file), is_below(file), true, -1)
SHIM(int, fdatasync, (int file), (file), is_below(file), true, -1)
SHIM(ssize_t, write, (int file, const void* bytes, size_t size), (file, bytes, size),
     is_below(file), true, -1)
SHIM(ssize_t, writev, (int file, const iovec* parts, int count), (file, parts, count),
     is_below(file), true, -1)
SHIM(ssize_t, read, (int file, void* bytes, size_t size), (file, bytes, size), is_below(file),
     false, -1)
SHIM(ssize_t, copy_file_range,
     (int in, off64_t* from, int out, off64_t* to, size_t size, unsigned flags),
     (in, from, out, to, size, flags), is_below(out), true, -1)
SHIM(ssize_t, sendfile, (int out, int in, off_t* from, size_t size), (out, in, from, size),
     is_below(out), true, -1)
SHIM(FILE*, fopen, (const char* path, const char* mode), (path, mode), is_below(path),
     std::strpbrk(mode, "wa") != nullptr, nullptr)
SHIM(FILE*, fopen64, (const char* path, const char* mode), (path, mode), is_below(path),
     std::strpbrk(mode, "wa") != nullptr, nullptr)

OPEN_CALLS
// NOLINTEND
