// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/stop_signals.hpp"

#include <unistd.h>

#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

volatile sig_atomic_t received_signal = 0;

void on_signal(int signal) {
  if (signal == SIGINT && received_signal == SIGINT) ::_exit(kInterrupted);
  received_signal = signal;
}

}  // namespace

StopSignals::StopSignals() {
  received_signal = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before_[i]);
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

int StopSignals::received() { return received_signal; }

}  // namespace legwright
