// SPDX-License-Identifier: Apache-2.0
// What both shims stand in front of: open() and its kin.
#pragma once

#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/types.h>

/// The library's function of that name behind ours.
template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

// Each calls fails_to_open(path, flags), which the shim defines, and then the library's function,
// or returns −1 with the errno that was set. NOLINTBEGIN
#define ARGS(...) __VA_ARGS__
#define OPEN(name, first, start)                                                    \
  extern "C" int name(first const char* path, int flags, ...) {                     \
    static const auto real = next<int (*)(first const char*, int, ...)>(#name);     \
    va_list rest;                                                                   \
    va_start(rest, flags);                                                          \
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                                                   \
    if (fails_to_open(path, flags)) return -1;                                      \
    return real(start path, flags, mode);                                           \
  }
#define OPEN_CALLS                                 \
  OPEN(open, , )                                   \
  OPEN(open64, , )                                 \
  OPEN(openat, ARGS(int folder, ), ARGS(folder, )) \
  OPEN(openat64, ARGS(int folder, ), ARGS(folder, ))
// NOLINTEND
