// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/start_of_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace legwright {
namespace {

/// Hands on to descriptor 2 what it takes, and says that all of it was written.
ssize_t write_message(void*, const char* bytes, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t written = ::write(STDERR_FILENO, bytes + done, size - done);
    if (written <= 0) break;
    done += static_cast<std::size_t>(written);
  }
  return static_cast<ssize_t>(size);
}

}  // namespace

void start_of_process() {
  for (int number = STDIN_FILENO; number <= STDERR_FILENO; ++number)
    if (::fcntl(number, F_GETFD) < 0) (void)::open("/dev/null", O_RDWR);  // gets that number
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  FILE* const messages =
      ::fopencookie(nullptr, "w", {.read = {}, .write = write_message, .seek = {}, .close = {}});
  if (messages == nullptr) return;
  std::setvbuf(messages, nullptr, _IONBF, 0);
  stderr = messages;
}

bool flush_stdout() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

}  // namespace legwright
