// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>

namespace legwright {

/// While one lives, SIGINT, SIGTERM, SIGHUP and SIGUSR1 only ask to stop; a second SIGINT ends the
/// process at once. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The signal that came, or 0.
  static int received();
  /// Whether one came.
  static bool asked() { return received() != 0; }

 private:
  static constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGHUP, SIGUSR1};
  std::array<struct sigaction, 4> before_;
};

}  // namespace legwright
