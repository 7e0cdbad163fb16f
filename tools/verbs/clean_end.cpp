// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/clean_end.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "tools/files/exit_code.hpp"
#include "tools/files/unfinished_path.hpp"

namespace legwright {
namespace {

/// From the handler, which may do next to nothing, to the thread that ends the program: the number
/// of the signal, 0 at the program's own end.
std::array<int, 2> end_pipe{-1, -1};
volatile sig_atomic_t end_asked = 0;

void tell_watcher(int signal) {
  const int error = errno;
  if (signal == SIGINT && end_asked == SIGINT) ::_exit(kInterrupted);
  end_asked = signal;
  const auto byte = static_cast<unsigned char>(signal);
  (void)!::write(end_pipe[1], &byte, 1);
  errno = error;
}

void end_cleanly() {
  unsigned char signal = 0;
  while (::read(end_pipe[0], &signal, 1) < 0 && errno == EINTR) {
  }
  if (signal == 0) return;
  remove_unfinished();
  ::signal(signal, SIG_DFL);
  ::kill(::getpid(), signal);
}

/// A thread that no signal interrupts.
std::thread start_watcher() {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread out;
  try {
    out = std::thread(end_cleanly);
  } catch (const std::system_error&) {
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return out;
}

}  // namespace

CleanEnd::CleanEnd() {
  if (::pipe2(end_pipe.data(), O_CLOEXEC) != 0) return;
  watcher_ = start_watcher();
  if (!watcher_.joinable()) return;
  struct sigaction action {};
  action.sa_handler = tell_watcher;
  handled_.emplace(action, StayIgnored::all);
}

CleanEnd::~CleanEnd() {
  handled_.reset();
  if (watcher_.joinable()) {
    const unsigned char over = 0;
    (void)!::write(end_pipe[1], &over, 1);
    watcher_.join();
  }
  for (int& end : end_pipe)
    if (end >= 0) ::close(std::exchange(end, -1));
}

}  // namespace legwright
