// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> g_count{0};
}  // namespace

namespace legwright {
long allocation_count() { return g_count.load(); }
}  // namespace legwright

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LEGWRIGHT_NEW_IS_TAKEN  // by its runtime: nothing is counted
#endif
#endif

#ifndef LEGWRIGHT_NEW_IS_TAKEN
void* operator new(std::size_t size) {
  ++g_count;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif
