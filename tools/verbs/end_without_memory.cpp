// SPDX-License-Identifier: Apache-2.0
// The program's malloc and its kin: those of the C library, or of a preloaded one, but where there
// is no memory they end the process, with a message and exit code 4, whoever asks, on any thread.
// Going on by exception is not to be had: Eigen's matrices free a block before they ask for the
// next, so that unwinding frees it twice; nlohmann::json and toml++ ask for memory in functions
// that may not throw; MuJoCo's compiler and Mesa write to what they did not get. What was written
// until then is as after a kill: of each file the old or the new one. The libraries, so Python,
// throw std::bad_alloc as ever.
#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "tools/files/exit_code.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LEGWRIGHT_MALLOC_IS_TAKEN  // a sanitizer has its own
#endif
#endif
#if defined(LEGWRIGHT_SANITIZED) || defined(__SANITIZE_THREAD__)
#define LEGWRIGHT_MALLOC_IS_TAKEN
#endif

#ifndef LEGWRIGHT_MALLOC_IS_TAKEN
namespace {

[[noreturn]] void end_without_memory() noexcept {
  constexpr char kMessage[] = "legwright: out of memory\n";
  (void)!::write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
  ::_exit(legwright::kInternal);
}

/// The function that stands behind ours, looked for once. Any thread may find it; all find one.
template <class Function>
Function* next(Function*& known, const char* name) noexcept {
  Function* found = __atomic_load_n(&known, __ATOMIC_RELAXED);
  if (found == nullptr) {
    found = reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
    __atomic_store_n(&known, found, __ATOMIC_RELAXED);
  }
  return found;
}

/// @param block null only where there is no memory, or what was asked for is nonsense
void* had(void* block) noexcept {
  if (block == nullptr && errno == ENOMEM) end_without_memory();
  return block;
}

void* (*next_malloc)(std::size_t) = nullptr;
void* (*next_calloc)(std::size_t, std::size_t) = nullptr;
void* (*next_realloc)(void*, std::size_t) = nullptr;
void* (*next_memalign)(std::size_t, std::size_t) = nullptr;
void* (*next_aligned_alloc)(std::size_t, std::size_t) = nullptr;
int (*next_posix_memalign)(void**, std::size_t, std::size_t) = nullptr;

}  // namespace

// Named and declared by the C library. NOLINTBEGIN
extern "C" {

void* malloc(std::size_t size) noexcept { return had(next(next_malloc, "malloc")(size)); }

void* calloc(std::size_t count, std::size_t size) noexcept {
  return had(next(next_calloc, "calloc")(count, size));
}

void* realloc(void* old, std::size_t size) noexcept {
  void* const block = next(next_realloc, "realloc")(old, size);
  return size == 0 ? block : had(block);  // of 0 bytes it frees
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return had(next(next_memalign, "memalign")(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return had(next(next_aligned_alloc, "aligned_alloc")(alignment, size));
}

int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
  const int error = next(next_posix_memalign, "posix_memalign")(out, alignment, size);
  if (error == ENOMEM) end_without_memory();
  return error;
}

}  // extern "C"
// NOLINTEND
#endif
