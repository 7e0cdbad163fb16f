// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>

namespace legwright {

/// Signals that ask a program to end.
inline constexpr std::array<int, 4> kEndSignals{SIGINT, SIGTERM, SIGHUP, SIGUSR1};

/// While one lives, they are handled by `action`, but for SIGHUP where whoever started the program
/// lets it be ignored, as nohup does: it stays so.
class HandledSignals {
 public:
  explicit HandledSignals(struct sigaction action);
  ~HandledSignals();
  HandledSignals(const HandledSignals&) = delete;
  HandledSignals& operator=(const HandledSignals&) = delete;

 private:
  std::array<struct sigaction, kEndSignals.size()> before_;
};

}  // namespace legwright
