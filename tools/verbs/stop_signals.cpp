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

/// Forgets what came before.
struct sigaction asking() {
  received_signal = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  return action;
}

}  // namespace

StopSignals::StopSignals() : handled_(asking(), StayIgnored::hang_up) {}

int StopSignals::received() { return received_signal; }

}  // namespace legwright
