// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/handled_signals.hpp"

namespace legwright {

HandledSignals::HandledSignals(struct sigaction action) {
  sigemptyset(&action.sa_mask);
  action.sa_flags |= SA_RESTART;
  for (std::size_t k = 0; k < kEndSignals.size(); ++k) {
    sigaction(kEndSignals[k], nullptr, &before_[k]);
    if (kEndSignals[k] != SIGHUP || before_[k].sa_handler != SIG_IGN)
      sigaction(kEndSignals[k], &action, nullptr);
  }
}

HandledSignals::~HandledSignals() {
  for (std::size_t k = 0; k < kEndSignals.size(); ++k)
    sigaction(kEndSignals[k], &before_[k], nullptr);
}

}  // namespace legwright
