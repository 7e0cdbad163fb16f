// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>

namespace legwright {

/// Signals that ask a program to end.
inline constexpr std::array<int, 4> kEndSignals{SIGINT, SIGTERM, SIGHUP, SIGUSR1};

/// Which of them stay ignored where whoever started the program had them ignored: SIGHUP, as nohup
/// does, or all, as of a script's job in the background.
enum class StayIgnored { hang_up, all };

/// While one lives, they are handled by `action`.
class HandledSignals {
 public:
  HandledSignals(struct sigaction action, StayIgnored stay);
  ~HandledSignals();
  HandledSignals(const HandledSignals&) = delete;
  HandledSignals& operator=(const HandledSignals&) = delete;

 private:
  std::array<struct sigaction, kEndSignals.size()> before_;
};

}  // namespace legwright
