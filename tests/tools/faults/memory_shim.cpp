// SPDX-License-Identifier: Apache-2.0
// Preloaded into a program: lets its n-th allocation get no memory. Counted are those, of all
// threads, from when the program first opens a file below a folder: the loader and static
// initialisation are not meant. A program that hangs is ended by SIGALRM.
//   FAULT_ROOT   the folder, as realpath() has it; the program is started in it
//   FAULT_AT     which allocation, from 1; 0: none
//   FAULT_HOW    once (this one alone), all (this and all later ones) or large (of these, the ones
//                of 4 kB and more)
//   FAULT_COUNT  a file that gets the number of allocations when the process ends
//   FAULT_TRACE  any text: who called is told on stderr
#include <execinfo.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "tests/tools/faults/open_calls.hpp"

// What stands behind the library's own functions of glibc.
extern "C" {
void* __libc_malloc(size_t size);                      // NOLINT
void* __libc_calloc(size_t count, size_t size);        // NOLINT
void* __libc_realloc(void* old, size_t size);          // NOLINT
void* __libc_memalign(size_t alignment, size_t size);  // NOLINT
}

namespace {

constexpr std::size_t kLarge = 4096;
constexpr unsigned kSeconds = 120;

enum class How { once, all, large };

// Read once, before the program begins; nothing here allocates.
const char* root = "";
const char* count_file = "";
bool traced = false;
long at = 0;
How how = How::once;
std::atomic<bool> counting{false};
std::atomic<long> calls{0};

const char* text(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

__attribute__((constructor)) void read_plan() {
  root = text("FAULT_ROOT");
  count_file = text("FAULT_COUNT");
  at = std::atol(text("FAULT_AT"));
  const char* const word = text("FAULT_HOW");
  traced = *text("FAULT_TRACE") != '\0';
  void* first[1];
  ::backtrace(first, 1);  // loads what it needs
  how = std::strcmp(word, "all") == 0     ? How::all
        : std::strcmp(word, "large") == 0 ? How::large
                                          : How::once;
  ::alarm(kSeconds);
}

__attribute__((destructor)) void tell_count() {
  counting = false;
  if (*count_file == '\0') return;
  const int file = ::open(count_file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0) return;
  ::dprintf(file, "%ld\n", calls.load());
  ::close(file);
}

void opened(const char* path) {
  if (*root == '\0' || path == nullptr) return;
  if (path[0] == '/' && std::strncmp(path, root, std::strlen(root)) != 0) return;
  counting = true;
}

void tell_callers() {
  constexpr int kMost = 40;
  void* frames[kMost];
  ::backtrace_symbols_fd(frames, ::backtrace(frames, kMost), STDERR_FILENO);
}

/// Whether this allocation gets nothing; errno says so.
bool fails(std::size_t size) {
  if (!counting.load(std::memory_order_relaxed)) return false;
  const long number = ++calls;
  if (at <= 0 || number < at) return false;
  if (how == How::once ? number != at : how == How::large && size < kLarge) return false;
  if (traced && number == at) tell_callers();
  errno = ENOMEM;
  return true;
}

bool fails_to_open(const char* path, int /*flags*/) {
  opened(path);
  return false;
}

}  // namespace

// Each stands before the library's function of that name. NOLINTBEGIN
extern "C" void* malloc(size_t size) { return fails(size) ? nullptr : __libc_malloc(size); }

extern "C" void* calloc(size_t count, size_t size) {
  return fails(count * size) ? nullptr : __libc_calloc(count, size);
}

extern "C" void* realloc(void* old, size_t size) {
  if (size > 0 && fails(size)) return nullptr;  // of 0 bytes it frees
  return __libc_realloc(old, size);
}

extern "C" void* memalign(size_t alignment, size_t size) {
  return fails(size) ? nullptr : __libc_memalign(alignment, size);
}

extern "C" void* aligned_alloc(size_t alignment, size_t size) {
  return fails(size) ? nullptr : __libc_memalign(alignment, size);
}

extern "C" int posix_memalign(void** out, size_t alignment, size_t size) {
  void* const block = fails(size) ? nullptr : __libc_memalign(alignment, size);
  if (block == nullptr) return ENOMEM;
  *out = block;
  return 0;
}

#define FOPEN(name)                                                            \
  extern "C" FILE* name(const char* path, const char* mode) {                  \
    static const auto real = next<FILE* (*)(const char*, const char*)>(#name); \
    opened(path);                                                              \
    return real(path, mode);                                                   \
  }
FOPEN(fopen)
FOPEN(fopen64)

OPEN_CALLS
// NOLINTEND
