// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/handled_signals.hpp"

namespace legwright {

HandledSignals::HandledSignals(struct sigaction action, StayIgnored stay) {
  sigemptyset(&action.sa_mask);
  action.sa_flags |= SA_RESTART;
  for (std::size_t k = 0; k < kEndSignals.size(); ++k) {
    sigaction(kEndSignals[k], nullptr, &before_[k]);
    const bool may_stay = stay == StayIgnored::all || kEndSignals[k] == SIGHUP;
    if (!may_stay || before_[k].sa_handler != SIG_IGN) sigaction(kEndSignals[k], &action, nullptr);
  }
}

HandledSignals::~HandledSignals() {
  for (std::size_t k = 0; k < kEndSignals.size(); ++k)
    sigaction(kEndSignals[k], &before_[k], nullptr);
}

}  // namespace legwright
